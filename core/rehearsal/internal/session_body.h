#pragma once
// One of a session's two bodies, at small strain (mechanics/contact/contact.h), at large (mechanics/contact/
// live_body.h) or in motion (mechanics/dynamics/moving_body.h): a state and tools give the next state.

#include <memory>
#include <variant>
#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/contact/live_body.h"
#include "mechanics/dynamics/moving_body.h"
#include "mechanics/dynamics/moving_live_body.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {

// Never empty.
using BodyState =
    std::variant<std::shared_ptr<const mechanics::ContactState>, std::shared_ptr<const mechanics::LiveState>,
                 std::shared_ptr<const mechanics::MovingState>, std::shared_ptr<const mechanics::MovingLiveState>>;

class SessionBody {
 public:
  // In motion where the setup says one, at small strain where the law is linear. The first `judged` watched places are
  // those that a bound is of. Failures: those of ContactBody, LiveBody and MovingBody.
  static Result<SessionBody> create(const mechanics::StaticModel& model, const mechanics::ChosenLaw& law,
                                    const RehearsalSetup& setup, const std::vector<mechanics::PointInMesh>& watched,
                                    std::size_t judged);

  [[nodiscard]] BodyState untouched() const;
  // A small move of the tools, to a state that is shown or one that only leads to the next; in motion a step in time.
  // Failures: "not-converged"
  // and those of the tools.
  enum class Shown { yes, no };
  [[nodiscard]] Result<BodyState> moved(const BodyState& from, const std::vector<mechanics::ContactTool>& tools,
                                        Shown shown = Shown::yes) const;
  // Some rounds nearer to rest; nothing changes where it rests. Failures: those of LiveBody::settle.
  [[nodiscard]] Result<BodyState> settled(const BodyState& from, const std::vector<mechanics::ContactTool>& tools,
                                          const Progress& progress) const;
  // What is kept of a state that is shown no more, and that state again, to the bit. Failure: "not-converged".
  [[nodiscard]] static BodyState without_shape(const BodyState& state);
  [[nodiscard]] Result<BodyState> with_shape(const BodyState& state) const;
  // With a cut opened further. Failures: those of ContactBody::opened and LiveBody::opened; "cut-in-motion".
  [[nodiscard]] Result<SessionBody> opened(const mechanics::CutStrip& strip) const;
  [[nodiscard]] Result<bool> prepare(const mechanics::CutStrip& ahead) const;  // as ContactBody's
  // ContactBody::prepare_touch; at large strain there is nothing to do.
  [[nodiscard]] Result<bool> prepare_touch(const BodyState& state,
                                           const std::vector<mechanics::ContactTool>& tools) const;
  // What its cut has come to in that state; nothing where none is open.
  [[nodiscard]] std::optional<SessionCut> cut(const BodyState& state) const;
  // Between two points of its walls that were one.
  [[nodiscard]] std::optional<double> largest_opening_mm(const BodyState& state) const;
  [[nodiscard]] Result<mechanics::StaticResult> whole_result(const BodyState& state) const;
  [[nodiscard]] const geometry::Surface& surface() const;

 private:
  using Body =
      std::variant<mechanics::ContactBody, mechanics::LiveBody, mechanics::MovingBody, mechanics::MovingLiveBody>;
  [[nodiscard]] const mechanics::Opening* opening() const;
  explicit SessionBody(Body body) : body_(std::move(body)) {}
  Body body_;
};

[[nodiscard]] const std::vector<Eigen::Vector3d>& surface_mm(const BodyState& state);
[[nodiscard]] const std::vector<Eigen::Vector3d>& watched_mm(const BodyState& state);
// Of the tools where they are: forces, torques about their own places, the bound.
[[nodiscard]] SessionStep step_of(const BodyState& state, const std::vector<mechanics::ContactTool>& tools,
                                  const geometry::Surface& surface);
[[nodiscard]] std::optional<SessionMotion> motion_of(const BodyState& state);
// Displacements and forces, bit for bit; at small strain those of the surface and the `judged` places. In motion speeds
// too.
[[nodiscard]] std::string bits_of(const BodyState& state, std::size_t judged);

}  // namespace glisson::rehearsal
