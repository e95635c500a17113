#include "mechanics/dynamics/moving_live_body.h"

#include <utility>

#include "mechanics/dynamics/internal/step_solver.h"
#include "mechanics/elements/internal/mass_matrix.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::mechanics {

using Eigen::VectorXd;

struct MovingLiveBody::Impl {
  DynamicsOptions options;
  VectorXd mass_kg;        // 3 equal values a node
  VectorXd inertia_mN_mm;  // (1 / h^2 + alpha / h) M
  LiveBody body;
  bool has_judged = false;
  MovingLiveState untouched = {};
};

namespace {

VectorXd lumped_kg(const Body& body) {
  constexpr double share_of_diagonal = 216.0 / 420.0;  // of a ten-node cell's mass: 4 corners of 6, 6 middles of 32
  return consistent_mass_kg(body).diagonal() / share_of_diagonal;
}

}  // namespace

Result<MovingLiveBody> MovingLiveBody::create(const StaticModel& at_rest, const ChosenLaw& law,
                                              const std::vector<Support>& supports, const Loads& standing_loads,
                                              std::vector<PointInMesh> watched, std::size_t judged,
                                              const DynamicsOptions& options, const Progress& progress) {
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  if (at_rest.reduced_functions() != nullptr || at_rest.nodes().order != ElementOrder::quadratic) {
    return failure("not-available", GLISSON_TEXT("A session in motion is by quadratic finite elements."));
  }
  if (options.stiffness_damping_s > 0) {
    return failure("not-available", GLISSON_TEXT("At large strain a session in motion is damped by its mass alone."));
  }
  const Body& body = at_rest.body();
  const double h = options.step_s;
  const VectorXd mass_kg = lumped_kg(body);
  const VectorXd inertia_mN_mm = (1 / (h * h) + options.mass_damping_per_s / h) * mass_kg;
  Eigen::SparseMatrix<double> of_step = assemble_stiffness(body);
  of_step += Eigen::SparseMatrix<double>(inertia_mN_mm.asDiagonal());
  auto system =
      ConstrainedSystem::create(std::move(of_step), body.resolved.fixed, body.options.memory_limit_bytes, progress);
  if (!system) return failure(std::move(system.error()));
  auto live = LiveBody::create(StaticModel::solved_by(body, std::make_shared<StepSolver>(std::move(*system))), law,
                               supports, standing_loads, std::move(watched), judged, inertia_mN_mm);
  if (!live) return failure(std::move(live.error()));
  auto parts = std::make_shared<Impl>(Impl{options, mass_kg, inertia_mN_mm, std::move(*live), judged > 0});
  static_cast<LiveState&>(parts->untouched) = parts->body.untouched();
  parts->untouched.v_mm_s = VectorXd::Zero(mass_kg.size());
  return MovingLiveBody(std::move(parts));
}

Result<MovingLiveState> MovingLiveBody::step(const MovingLiveState& from, const std::vector<ContactTool>& tools) const {
  const Impl& parts = *impl_;
  LiveOptions options;
  options.most_rounds = 8;
  options.gradients = 12;
  options.shown_mm = parts.has_judged ? 0.22 : 0;  // less than a hundredth of a millimetre is left
  options.besides_mN = std::make_shared<const VectorXd>(parts.inertia_mN_mm.cwiseProduct(from.u_mm) +
                                                        parts.mass_kg.cwiseProduct(from.v_mm_s) / parts.options.step_s);
  auto next = parts.body.step(from, tools, options);
  if (!next) return failure(std::move(next.error()));
  MovingLiveState moved;
  static_cast<LiveState&>(moved) = std::move(*next);
  const VectorXd change_mm = moved.u_mm - from.u_mm;
  moved.v_mm_s = change_mm / parts.options.step_s;
  static_cast<Movement&>(moved) = moved_on(from, change_mm, parts.options.step_s, parts.options.step_s);
  return moved;
}

StaticResult MovingLiveBody::whole_result(const MovingLiveState& state) const {
  return impl_->body.whole_result(state);
}
const MovingLiveState& MovingLiveBody::untouched() const { return impl_->untouched; }
const geometry::Surface& MovingLiveBody::surface() const { return impl_->body.surface(); }

}  // namespace glisson::mechanics
