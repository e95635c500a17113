#include "mechanics/dynamics/newton_implicit_euler.h"

#include <utility>

#include "base/stopwatch.h"
#include "mechanics/dynamics/internal/incremental_potential.h"
#include "mechanics/elements/strain.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {
using Eigen::VectorXd;

Result<NewtonImplicitEuler> NewtonImplicitEuler::create(Body body, std::vector<Material> materials, AppliedLoads loads,
                                                        const DynamicsOptions& options) {
  GLISSON_ASSERT(body.options.order == ElementOrder::linear && materials.size() == body.mesh.cells.size());
  if (auto checked = check_dynamics_options(options); !checked) return failure(std::move(checked.error()));
  NewtonImplicitEuler motion;
  motion.body_ = std::move(body);
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
  return step(loads_, [&](const Potential& potential, double scale_mN, const VectorXd& from_mm) {
    return minimise(potential, body_.resolved.fixed, scale_mN, from_mm,
                    {options_.relative_tolerance, options_.max_iterations, body_.options.memory_limit_bytes}, progress);
  });
}

Result<StepReport> NewtonImplicitEuler::step(const AppliedLoads& loads, const Settle& settle) {
  const Stopwatch watch;
  const IncrementalPotential potential(body_, materials_, loads, options_, mass_kg_, u_mm_, v_mm_s_);
  auto descent = settle(potential, potential.scale_mN(), u_mm_);
  if (!descent) return failure(std::move(descent.error()));
  StepReport report;
  report.converged = descent->converged && descent->u_mm.allFinite();
  report.relative_residual = descent->relative_residual;
  report.iterations = descent->steps;
  if (report.converged) {
    v_mm_s_ = (descent->u_mm - u_mm_) / options_.step_s;
    u_mm_ = std::move(descent->u_mm);
  }
  report.inverted_cells = strain_range(body_.mesh, body_.layout, u_mm_, StrainMeasure::stretch).inverted_cells;
  report.strain_energy_uJ = strain_energy_uJ(body_, materials_, u_mm_);
  report.kinetic_energy_uJ = 0.5 * v_mm_s_.dot(mass_kg_ * v_mm_s_);
  report.step_ms = 1e3 * watch.seconds();
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
