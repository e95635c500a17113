#include "mechanics/dynamics/newton_implicit_euler.h"

#include <utility>

#include "base/stopwatch.h"
#include "mechanics/contact/internal/augmented_lagrangian.h"
#include "mechanics/dynamics/internal/implicit_step.h"
#include "mechanics/elements/strain.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {
using Eigen::VectorXd;

Result<NewtonImplicitEuler> NewtonImplicitEuler::create(Body body, std::vector<Material> materials, AppliedLoads loads,
                                                        const DynamicsOptions& options) {
  GLISSON_ASSERT(body.options.order == ElementOrder::linear && materials.size() == body.mesh.cells.size());
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  NewtonImplicitEuler motion;
  motion.body_ = std::move(body);
  if (!options.relaxation.empty()) {
    motion.history_.emplace(motion.body_, materials, options.relaxation, options.step_s);
    const double share = share_within(options.relaxation, options.step_s);
    for (Material& material : materials) material = scaled(material, share);
  }
  motion.materials_ = std::move(materials);
  motion.loads_ = std::move(loads);
  motion.options_ = options;
  const VectorXd lumped_kg = lumped_mass_kg(motion.body_);
  motion.mass_kg_ = Eigen::SparseMatrix<double>(lumped_kg.asDiagonal());
  motion.u_mm_ = VectorXd::Zero(lumped_kg.size());
  motion.v_mm_s_ = motion.u_mm_;
  return motion;
}

Result<StepReport> NewtonImplicitEuler::step(const Progress& progress) {
  const Stopwatch watch;
  const ImplicitStep step(body_, materials_, loads_, options_, mass_kg_, u_mm_, v_mm_s_, older());
  const auto found =
      minimise(step.potential(), body_.resolved.fixed, step.scale_mN(), u_mm_,
               {options_.relative_tolerance, options_.max_iterations, body_.options.memory_limit_bytes}, progress);
  if (!found) return failure(found.error());
  StepReport report = moved_to(found->u_mm, {found->converged, found->relative_residual, found->steps});
  report.step_ms = 1e3 * watch.seconds();
  return report;
}

Result<StepReport> NewtonImplicitEuler::step(const AppliedLoads& loads, const MinimiseWithTools& minimise_with_tools,
                                             const Progress& progress) {
  const Stopwatch watch;
  const ImplicitStep step(body_, materials_, loads, options_, mass_kg_, u_mm_, v_mm_s_, older());
  Minimum minimum{u_mm_};
  const auto rested =
      minimise_with_tools({step.potential(),
                           step.scale_mN(),
                           NodalUnknowns(body_),
                           minimum,
                           {options_.relative_tolerance, options_.max_iterations, body_.options.memory_limit_bytes},
                           progress});
  if (!rested) return failure(rested.error());
  StepReport report = moved_to(minimum.x_mm, {*rested, minimum.relative_residual, minimum.newton_steps});
  report.step_ms = 1e3 * watch.seconds();
  return report;
}

Potentials NewtonImplicitEuler::older() const { return history_ ? history_->potentials(body_) : Potentials(); }

// With what the body is after it.
StepReport NewtonImplicitEuler::moved_to(const VectorXd& u_mm, StepReport report) {
  report.converged = report.converged && u_mm.allFinite();
  if (report.converged) {
    v_mm_s_ = (u_mm - u_mm_) / options_.step_s;
    u_mm_ = u_mm;
    if (history_) history_->advance(body_, u_mm_);
  }
  report.inverted_cells = strain_range(body_.mesh, body_.layout, u_mm_, StrainMeasure::stretch).inverted_cells;
  report.strain_energy_uJ = history_ ? history_->free_energy_uJ(body_) : strain_energy_uJ(body_, materials_, u_mm_);
  report.kinetic_energy_uJ = 0.5 * v_mm_s_.dot(mass_kg_ * v_mm_s_);
  return report;
}

void NewtonImplicitEuler::set_velocity(const VectorXd& velocity_mm_s) {
  v_mm_s_ = free_values(body_.resolved.fixed, velocity_mm_s);
}

VectorXd lumped_mass_kg(const Body& body) {
  VectorXd mass_kg = VectorXd::Zero(3 * static_cast<Eigen::Index>(body.layout.nodes()));
  for (std::size_t c = 0; c < body.layout.cells.size(); ++c) {
    const double quarter_kg = 0.25 * body.options.density_kg_mm3 * geometry::cell_volume_mm3(body.mesh, c);
    for (int i = 0; i < 4; ++i) mass_kg.segment<3>(3 * body.layout.cells[c][i]).array() += quarter_kg;
  }
  return mass_kg;
}

}  // namespace glisson::mechanics
