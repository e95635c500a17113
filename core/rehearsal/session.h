#pragma once
// A rehearsal with tools in the hand: the patient's liver and its reference body (the atlas) under the same tools, step
// by step.
//
// SessionEngine is the rehearsal itself, without a clock: a command and what was before give the next state, always the
// same to the bit. LiveSession runs one on a thread of its own and never keeps its caller waiting.
//
// At small strain (RehearsalSetup::law is linear) a state is at rest. At large strain (mechanics/contact/live_body.h) a
// command gives a first picture, with a bound of how far its landmarks are from rest. Settle brings it nearer. A
// LiveSession settles by itself while nobody asks for more, and records that it did. A Settle under way is given up for
// what is asked, and is in no recording.
//
// A meshfree session (RehearsalSetup::meshfree) is of small strain. Beside its patient the same stands by finite
// elements, under the same tools and cut alike, so that each state says how far they are apart.
//
// A session in motion (RehearsalSetup::motion, mechanics/dynamics/moving_body.h, moving_live_body.h) is by finite
// elements and uncut. A command of a tool passes as many steps of time as it has small moves, one at least. Wait passes
// more. Undo gives back what moved before a command, with its speed. The reference body moves beside the patient from
// the beginning. A LiveSession waits by itself while anything moves, never faster than the clock, and records that it
// did.
//
// A LiveSession answers of the patient alone while the reference body is still being made, and then compares.
//
// The phases, and what can be asked in each. A session is `preparing` while there is nothing to show yet, and `failed`
// where it never came to be, and says why. `ready` means that the latest state is of all that was asked, and stays.
// `settling` means that it is of all that was asked, and is brought nearer to rest, or still moves. `comparing` means
// that it is of all that was asked, and of the patient alone: the reference body is on its way. `stepping` means that
// it is of what came before. A force without a tool, a tool without a pose or a state before the model cannot be said.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/contact/contact.h"
#include "rehearsal/session_cut.h"
#include "rehearsal/static_rehearsal.h"

namespace glisson::rehearsal {

// Takes a tool, or moves, turns, pushes the one of that id.
struct HoldTool {
  mechanics::ContactTool tool;
};
struct ReleaseTool {
  std::string id;
};
// Opens a cut further, in every body (mechanics/cutting/opening.h).
struct AdvanceCut {
  mechanics::CutStrip strip;
};
// Back to before the last command that was not undone. What was undone is gone.
struct Undo {};
// Some rounds nearer to rest. What undo goes back to stays.
struct Settle {};
// The reference body comes under the tools where they are, in a session that began without it. What undo goes back to
// stays, and is compared too.
struct Compare {};
// So many steps of time pass, in motion, with the tools as they are. What undo goes back to stays.
struct Wait {
  int steps = 1;
};
using SessionCommand = std::variant<HoldTool, ReleaseTool, Undo, Settle, AdvanceCut, Compare, Wait>;

// When the reference body comes into a session, where there is one.
enum class WithReference { at_once, when_asked };

struct SessionStep {
  mechanics::ContactReport report;
  std::vector<mechanics::ToolContact> tools;
  Eigen::Vector3d torque_mNmm{0, 0, 0};  // of the tools on the body, each about its own place, all together
  std::optional<double> error_bound_mm;  // at large strain: of the landmarks, against where they come to rest
  bool settled = true;
};

// Of a session in motion.
struct SessionMotion {
  double time_s = 0;              // since the session began
  double largest_speed_mm_s = 0;  // of any place of the patient's body
  bool moves = false;             // either body
};

// The patient by the meshfree engine and by finite elements, under the same tools: what a few hundred nodes cost, and
// what they cannot follow.
struct BesideElements {
  double landmarks_mm = 0, surface_mm = 0;        // how far they are apart at most; without landmarks 0
  std::optional<double> largest_opening_mm = {};  // of a cut, by finite elements; by nodes: SessionCut
  double meshfree_ms = 0, elements_ms = 0;        // that the last command took
};

struct SessionState {
  std::uint64_t number = 0;   // of the commands that led here
  std::uint64_t settles = 0;  // of them, those since the last that was no Settle
  int on_the_way = 0;         // small moves that the next command has made; 0 where none is under way
  std::vector<mechanics::ContactTool> tools;
  RehearsalBody patient;
  std::optional<RehearsalBody> reference;
  SessionStep patient_step;
  mechanics::Validity validity = {};  // of the patient's body, its strain by the corners of cells
  std::optional<SessionStep> reference_step;
  std::shared_ptr<const SessionCut> cut;  // nullptr: nothing is cut
  std::optional<SessionMotion> motion;    // absent: this is at rest
  // Of a meshfree session, where finite elements found a shape too.
  std::optional<BesideElements> beside_elements;
  std::optional<double> error_bound_mm;         // the larger of both bodies'
  bool settled = true;                          // both
  std::vector<LandmarkDifference> differences;  // those of 5 mm and more are significant()
  double max_difference_mm = 0;                 // over the surface
  // Empty where the last command was carried out. Otherwise why it was not. The state then shows what was before it,
  // and says so here. A shape that did not converge is never shown.
  std::string refused;
  std::optional<Error> refusal = {};  // the same, where the body or the tools said it
  double step_ms = 0;
  // SHA-256 of forces and displacements, at small strain of the surface and the landmarks: two states of the same
  // digest are the same bits there.
  std::string digest;
};

class SessionEngine {
 public:
  // Failures: those of StaticRehearsal::create, of LiveBody::create and of MovingBody::create; "not-available" (a
  // meshfree motion).
  static Result<SessionEngine> create(RehearsalSetup setup, const Progress& progress = {},
                                      WithReference reference = WithReference::at_once);

  // Makes the reference body, which takes as long as create; Compare then does not wait for it. May run beside steps.
  // Nothing where it is there, or there is none. Failures: those of create.
  [[nodiscard]] Result<void> make_reference(const Progress& progress = {}) const;
  [[nodiscard]] bool has_reference() const;

  // A bound beyond which a state says that it is still settling.
  static constexpr double shown_mm = 0.5;
  static constexpr int most_waited_steps = 10000;  // of one command
  // Settle commands after which a state that has not come to rest will not.
  static constexpr int most_settles = 24;

  // One step. Large moves are made in small ones, which only the last shows. Undo reaches back over 10,000 steps, at
  // large strain and in motion over 100. A Settle or Wait that is cancelled has never been: state, number and digest
  // are as before. `told`, at large strain and in motion, gets the states on the way.
  using Told = std::function<void(std::shared_ptr<const SessionState>)>;
  const SessionState& step(const SessionCommand& command, const Progress& progress = {}, const Told& told = {});
  // The present state at rest, as Settle after Settle makes it; the session stays where it is.
  [[nodiscard]] SessionState settled_state() const;

  // A tenth of a second's work for what may be asked next: what a cut would open if it went on, and what tools would
  // touch near where they are. No state changes by it, nor its bits. False where there is nothing to do.
  [[nodiscard]] bool prepare() const;

  [[nodiscard]] const SessionState& state() const;
  [[nodiscard]] std::shared_ptr<const SessionState> shared_state() const;
  [[nodiscard]] const geometry::Surface& surface() const;
  // Every mesh point's displacement in the present state, by a solve of its own.
  [[nodiscard]] Result<mechanics::StaticResult> whole_result() const;

 private:
  struct Impl;
  explicit SessionEngine(std::shared_ptr<Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<Impl> impl_;
};

enum class SessionPhase { preparing, ready, settling, comparing, stepping, failed };

class LiveSession {
 public:
  // Returns at once; the model is built on the session's thread.
  explicit LiveSession(RehearsalSetup setup);
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;
  ~LiveSession();  // stops the preparing, or waits for the step under way

  // Returns at once. Of several waiting moves of one tool only the last is made.
  void post(SessionCommand command);

  [[nodiscard]] SessionPhase phase() const;
  [[nodiscard]] std::shared_ptr<const SessionState> latest() const;  // nullptr until there is one
  [[nodiscard]] std::optional<Error> error() const;                  // why it failed

  // What was carried out, with each state's digest: enough to see it again.
  [[nodiscard]] std::vector<std::pair<SessionCommand, std::string>> recording() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A recording as JSON, "glisson-session/1": {"commands": [{"hold": {...}} | {"release": id} | {"undo": true} |
// {"settle": true} | {"compare": true} | {"wait_steps": n}], each with "digest" where it was recorded}. Failures of
// reading: "session-invalid" (which command, and what about it).
using Recording = std::vector<std::pair<SessionCommand, std::string>>;
[[nodiscard]] std::string recording_text(const Recording& recording);
Result<Recording> parse_recording(std::string_view json, const std::filesystem::path& file = {});

// When the reference body was there: at once, unless a command asks for it.
[[nodiscard]] WithReference reference_in(const Recording& recording);

// Steps through all commands. The first whose state is not the one recorded, from 0; nothing where all are.
[[nodiscard]] std::optional<std::size_t> replay(SessionEngine& engine, const Recording& recording);

}  // namespace glisson::rehearsal
