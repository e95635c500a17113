#pragma once
// What a session engine holds: the moments that commands led to, and how the next is made of the last
// (session_moments.cpp). session.cpp is the commands.

#include <functional>
#include <mutex>
#include <utility>

#include "rehearsal/internal/session_body.h"
#include "rehearsal/internal/tools_between.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {

// All that a command starts from, and undo goes back to.
struct Moment {
  Tools tools;
  SessionBody patient_body;
  std::optional<SessionBody> reference_body;
  BodyState patient;
  std::optional<BodyState> reference;
  std::vector<mechanics::CutStrip> cuts = {};
  std::vector<std::size_t> crossed = {};          // of the setup's structures, ascending
  std::optional<SessionBody> elements_body = {};  // of a meshfree session: the patient by finite elements
  std::optional<BodyState> elements = {};         // absent where they found no shape
  double patient_ms = 0, elements_ms = 0;
};

struct SessionEngine::Impl {
  mechanics::ChosenLaw law = mechanics::MaterialLaw::linear;
  std::vector<mechanics::Landmark> landmarks;
  std::vector<mechanics::PointInMesh> landmark_places;
  std::vector<geometry::Surface> structures;
  std::vector<Moment> moments;  // the first untouched, the last the present; only that one has its shape
  std::uint64_t commands = 0, settles = 0;
  std::shared_ptr<const SessionState> latest;
  bool compares = false;  // every moment has its reference body
  bool in_motion = false;

  // Made once, whoever asks first; the others wait.
  std::function<Result<SessionBody>(const Progress&)> reference_maker;  // none: there is no reference body
  mutable std::mutex making;
  mutable std::optional<SessionBody> reference;
  [[nodiscard]] Result<void> make_reference(const Progress& progress) const;
  // A body that was untouched, cut as the patient is and under its tools, which come to it afresh.
  [[nodiscard]] Result<std::pair<SessionBody, BodyState>> brought_to(const Moment& moment, SessionBody body) const;
  // With the reference body where it is missing.
  [[nodiscard]] Result<Moment> compared(Moment moment) const;
  void compare_the_last();
  [[nodiscard]] std::string begin_to_compare();  // why not; empty where it does

  // What `next` makes of both bodies, the reference body beside the patient's on a thread of its own.
  using Next = std::function<Result<BodyState>(const SessionBody&, const BodyState&)>;
  [[nodiscard]] Result<Moment> both(const Moment& from, const Tools& tools, const Next& next) const;
  void answer_by_elements(Moment& moment, const Next& next) const;
  // The tools go from there to there, in so many small moves.
  [[nodiscard]] int small_moves(const Tools& from, const Tools& tools) const;
  [[nodiscard]] Next way_to(const Tools& from, const Tools& tools) const;
  // At large strain and in motion `told` gets each moment on the way, and how many moves led to it.
  using OnTheWay = std::function<void(const Moment&, int)>;
  [[nodiscard]] Result<Moment> moved(const Moment& from, const Tools& tools, const OnTheWay& told = {}) const;
  // So many steps of time later; the same at rest. Failures: "cancelled", those of SessionBody::moved.
  [[nodiscard]] Result<Moment> later(const Moment& from, int steps, const Progress& progress) const;
  [[nodiscard]] Result<Moment> nearer_to_rest(const Moment& from, const Progress& progress = {}) const;
  [[nodiscard]] Result<Moment> cut(const Moment& from, const mechanics::CutStrip& strip) const;
  void go_on_to(Moment moment);
  [[nodiscard]] Result<void> go_back();
  [[nodiscard]] RehearsalBody shown(const SessionBody& body, const BodyState& state) const;
  [[nodiscard]] std::shared_ptr<const SessionCut> cut_of(const Moment& moment) const;
  [[nodiscard]] std::optional<BesideElements> beside_elements(const Moment& moment) const;
  [[nodiscard]] SessionState state_of(const Moment& moment) const;
};

}  // namespace glisson::rehearsal
