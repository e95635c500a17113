#pragma once
// The rehearsal as the window lives it. Tools are placed off the UI thread; force and direction change at once.
// All that is done is recorded, and any moment of it can be seen again.
//
// The reference body is made when the first tool is placed, or a session begins. Until it is there, answers are of the
// patient alone, and more is being solved for.
//
// A tool either spreads its force over a patch (one tool), or is the rigid thing itself in contact (several tools). At
// small deformations every answer to a patch is exact and comes in a millisecond; all else is answered by a session
// (rehearsal/session.h). At large ones its first pictures are brought to rest in the background. The picture of a
// moment is replaced by one nearer to rest, and each says how far from rest its landmarks may be.

#include <deque>
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "rehearsal/tool_presets.h"
#include "widgets/session/rehearsal_track.h"

namespace glisson::widgets {

// Meshfree: small ones by the meshfree engine, with finite elements beside it to be held against. Moving: small ones in
// motion.
enum class Deformations { small, large, meshfree, moving };
// Settling: what was asked is answered, and is being brought to rest. Unsettled: it did not come there.
enum class Solving { no_tool, solving, settling, solved, unsettled, refused };

class LiveRehearsal : public QObject {
  Q_OBJECT

 public:
  explicit LiveRehearsal(QObject* parent = nullptr);
  ~LiveRehearsal() override;

  // Starts anew with this body, no tool on it; nullptr for none. Rigid tools need the setup that it was made from.
  void set_body(std::shared_ptr<const rehearsal::StaticRehearsal> body,
                std::shared_ptr<const rehearsal::RehearsalSetup> setup = nullptr);
  // The same patient read anew. On the same mesh the tools stay where they are and how they touch. What was recorded
  // stays, with the figures of the organ as it was then. On another mesh it starts anew.
  void exchange_body(std::shared_ptr<const rehearsal::StaticRehearsal> body,
                     std::shared_ptr<const rehearsal::RehearsalSetup> setup);
  [[nodiscard]] const rehearsal::StaticRehearsal* body() const { return body_.get(); }
  [[nodiscard]] bool knows_rigid_tools() const { return setup_ != nullptr; }

  // Starts anew: the track of one is no track of the other.
  void set_touch(Touch touch);
  [[nodiscard]] Touch touch() const { return touch_; }

  // The liver linear, or neo-Hookean with the same stiffness. Starts anew with the same tools; meshfree and moving ones
  // are rigid.
  void set_deformations(Deformations deformations);
  [[nodiscard]] Deformations deformations() const { return deformations_; }
  // Anisotropic tissue is known at small ones by finite elements alone.
  [[nodiscard]] bool knows_other_deformations() const { return setup_ && !setup_->options.anisotropy; }
  // In motion the patient's tissue does, as accepted evidence says.
  [[nodiscard]] bool creeps() const { return setup_ && !setup_->relaxation.empty(); }

  // Puts the tool there. A later call supersedes this one: of several on the way, only the last is solved for.
  void hold(const PlacedTool& tool);
  // The same with no more force than leaves the answer within the model, in steps of 0.1 N: for a force that nobody
  // has chosen. A rigid tool, whose answer is not known beforehand, keeps its force; so does any at large deformations.
  void hold_within_the_model(const PlacedTool& tool);
  void set_force_N(double force_N);
  void set_direction(const Eigen::Vector3d& unit);  // of the force
  void take_tool_away();                            // the one in hand; another that was kept comes to hand
  // These tools and no others, with as few movements as lead there; at most one where tools are patches.
  void hold_all(const std::vector<PlacedTool>& tools);
  // The tool stays where it is, and the next one held is another. With rigid tools only.
  void keep_tool();

  // Opens a cut further, with rigid tools only; the answer comes as theirs do. The last ones close again as long as no
  // tool was moved since.
  void advance_cut(const mechanics::CutStrip& strip);
  void take_cut_back();
  [[nodiscard]] bool can_take_cut_back() const;
  [[nodiscard]] int cut_steps() const { return cut_steps_; }         // that are open
  [[nodiscard]] std::vector<mechanics::CutStrip> cut_along() const;  // those steps
  // That cut and no other. Where what is open cannot be taken back, the session starts anew with the same tools.
  void cut_all(const std::vector<mechanics::CutStrip>& wanted);

  // Of all that is answered by a session: a name that no other session has, and what it carried out, with digests.
  // Empty outside of one.
  [[nodiscard]] const std::string& session_name() const { return session_name_; }
  [[nodiscard]] rehearsal::Recording recording() const;

  // Nothing moves any tool while it is frozen.
  void set_frozen(bool frozen);
  [[nodiscard]] bool frozen() const { return frozen_; }

  [[nodiscard]] bool has_tool() const { return !tools().empty(); }
  // Those of what is shown, the one in hand last.
  [[nodiscard]] const std::vector<PlacedTool>& tools() const;
  [[nodiscard]] Eigen::Vector3d tool_center_mm() const;
  // Of rigid tools, in their order, where they are now; empty otherwise.
  [[nodiscard]] const std::vector<mechanics::ToolShape>& solids() const { return solids_; }
  [[nodiscard]] double force_N() const { return force_N_; }
  [[nodiscard]] const Eigen::Vector3d& direction() const { return direction_; }
  [[nodiscard]] const std::optional<rehearsal::RehearsalState>& state() const { return state_; }

  [[nodiscard]] Solving solving() const { return solving_; }
  // Of a session: the state is of all that was asked for.
  [[nodiscard]] bool answered() const { return session_ && answered_; }
  // A session is on its way that has nothing to show yet.
  [[nodiscard]] bool preparing() const { return session_ && !session_number_ && !refusal_; }
  // What is shown, where a session answered it; nullptr otherwise.
  [[nodiscard]] const rehearsal::SessionState* contact() const { return state_ ? contact_.get() : nullptr; }
  // How far the landmarks that are shown may be from rest; nothing at small deformations or without landmarks.
  [[nodiscard]] std::optional<double> error_bound_mm() const;
  // Why the last command was not carried out; the state is of what was before it.
  [[nodiscard]] const std::optional<Error>& refusal() const { return refusal_; }
  // The largest force along the present direction that stays within the model, at most `maximum_N`; known of a patch
  // at small deformations alone.
  [[nodiscard]] std::optional<double> force_within_the_model_N(double maximum_N) const;

  [[nodiscard]] const RehearsalTrack& track() const { return track_; }
  void clear_track();
  // Shows a moment of the track, until go_on() or the next command.
  void show_moment(std::size_t moment);
  void go_on();
  [[nodiscard]] std::optional<std::size_t> shown_moment() const { return shown_moment_; }

 Q_SIGNALS:
  void state_changed();  // state() is new, or gone; or the tools moved
  void solving_changed();
  void track_changed();
  void placed(double solve_ms);
  void failed(const glisson::Error& error);

 private:
  void solve_for(const PlacedTool& tool);
  void make_reference();
  [[nodiscard]] const rehearsal::PlacedTool* remembered(const PlacedTool& tool) const;
  void answer_now();
  void ease(const rehearsal::PlacedTool& placed);
  void show_answer(const rehearsal::PlacedTool& placed, const PlacedTool& tool);
  void show_contact(const std::shared_ptr<const rehearsal::SessionState>& state, Solving solving);
  void look_for_contact();
  void post(rehearsal::SessionCommand command);
  void post_tool();
  void record(std::shared_ptr<const rehearsal::SessionState> contact);
  [[nodiscard]] bool in_session() const { return touch_ == Touch::rigid || deformations_ != Deformations::small; }
  void set_solving(Solving solving);
  void refuse(const Error& error);
  [[nodiscard]] rehearsal::RehearsalSetup session_setup() const;
  void start_anew();
  void change_tool(const std::function<void(PlacedTool&)>& change);

  std::shared_ptr<const rehearsal::StaticRehearsal> body_;
  std::shared_ptr<const rehearsal::RehearsalSetup> setup_;
  Touch touch_ = Touch::patch;
  Deformations deformations_ = Deformations::small;
  bool frozen_ = false;
  double force_N_ = 0;
  Eigen::Vector3d direction_{0, -1, 0};
  std::vector<PlacedTool> tools_;  // the one in hand last
  std::vector<int> numbers_;       // of the tools in the session of rigid ones
  int next_number_ = 0;
  bool takes_another_ = false;
  bool eases_ = false;     // the force is nobody's choice yet
  bool answered_ = false;  // all that the session was asked
  std::optional<rehearsal::RehearsalState> state_;
  Solving solving_ = Solving::no_tool;
  std::optional<Error> refusal_;
  std::vector<mechanics::ToolShape> solids_;

  // Answers to the places of late; going back to one costs no solve.
  std::deque<rehearsal::PlacedTool> placed_;
  bool is_placing_ = false;
  bool is_making_reference_ = false;
  std::optional<PlacedTool> to_place_;
  int body_count_ = 0;  // so that what was solved for another body is known when it arrives

  // The last answer of force_within_the_model_N, and to what.
  struct Within {
    PlacedTool tool;
    double maximum_N = 0;
    int body_count = 0;
    double force_N = 0;
  };
  mutable std::optional<Within> within_;

  std::unique_ptr<rehearsal::LiveSession> session_;
  std::optional<std::pair<std::uint64_t, int>> session_number_;  // and moves on the way, of the last state seen
  std::shared_ptr<const rehearsal::SessionState> contact_;
  std::string session_name_;
  int cut_steps_ = 0;
  int cuts_since_tool_ = 0;
  std::vector<mechanics::CutStrip> strips_;  // asked for; more than the steps that are open where some were refused
  QTimer session_timer_;

  RehearsalTrack track_;
  QElapsedTimer clock_;
  std::optional<std::size_t> shown_moment_;
};

}  // namespace glisson::widgets
