#pragma once
// One of a session's two bodies, at small strain (mechanics/contact/contact.h) or at large (mechanics/contact/
// live_body.h): a state and tools give the next state.

#include <memory>
#include <variant>
#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/contact/live_body.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {

// Never empty.
using BodyState =
    std::variant<std::shared_ptr<const mechanics::ContactState>, std::shared_ptr<const mechanics::LiveState>>;

class SessionBody {
 public:
  // At small strain where the law is linear. The first `judged` watched places are those that a bound is of. Failures:
  // those of ContactBody and LiveBody.
  static Result<SessionBody> create(const mechanics::StaticModel& model, const RehearsalSetup& setup,
                                    const std::vector<mechanics::PointInMesh>& watched, std::size_t judged);

  [[nodiscard]] BodyState untouched() const;
  // A small move of the tools. Failures: "not-converged" and those of the tools.
  [[nodiscard]] Result<BodyState> moved(const BodyState& from, const std::vector<mechanics::ContactTool>& tools) const;
  // Some rounds nearer to rest; nothing changes where it rests. Failures: those of LiveBody::settle.
  [[nodiscard]] Result<BodyState> settled(const BodyState& from, const std::vector<mechanics::ContactTool>& tools,
                                          const Progress& progress) const;
  // With a cut opened further. Failures: those of ContactBody::opened and LiveBody::opened.
  [[nodiscard]] Result<SessionBody> opened(const mechanics::CutStrip& strip) const;
  [[nodiscard]] Result<bool> prepare(const mechanics::CutStrip& ahead) const;  // as ContactBody's
  // What its cut has come to in that state; nothing where none is open.
  [[nodiscard]] std::optional<SessionCut> cut(const BodyState& state) const;
  // Between two points of its walls that were one.
  [[nodiscard]] std::optional<double> largest_opening_mm(const BodyState& state) const;
  [[nodiscard]] Result<mechanics::StaticResult> whole_result(const BodyState& state) const;
  [[nodiscard]] const geometry::Surface& surface() const;

 private:
  using Body = std::variant<mechanics::ContactBody, mechanics::LiveBody>;
  explicit SessionBody(Body body) : body_(std::move(body)) {}
  Body body_;
};

[[nodiscard]] const std::vector<Eigen::Vector3d>& surface_mm(const BodyState& state);
[[nodiscard]] const std::vector<Eigen::Vector3d>& watched_mm(const BodyState& state);
// Of the tools where they are: forces, torques about their own places, the bound.
[[nodiscard]] SessionStep step_of(const BodyState& state, const std::vector<mechanics::ContactTool>& tools,
                                  const geometry::Surface& surface);
// Every displacement and force, bit for bit.
[[nodiscard]] std::string bits_of(const BodyState& state);

}  // namespace glisson::rehearsal
