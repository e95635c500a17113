#include "mechanics/newton_motion.h"

#include <cmath>
#include <utility>

#include "mechanics/newton.h"
#include "mechanics/stopwatch.h"
#include "mechanics/strain.h"
#include "mechanics/surroundings.h"

namespace glisson::mechanics {
namespace {

using Eigen::SparseMatrix;
using Eigen::VectorXd;

// One step as the landscape whose least it is.
class StepLandscape : public Landscape {
 public:
  StepLandscape(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                const MotionOptions& options, const VectorXd& mass_kg, const VectorXd& u_mm, const VectorXd& v_mm_s)
      : body_(body),
        materials_(materials),
        loads_(loads),
        mass_kg_(mass_kg),
        from_mm_(u_mm),
        coasted_mm_(u_mm + options.step_s * v_mm_s),
        inertia_(1.0 / (options.step_s * options.step_s)),
        drag_(options.mass_damping_per_s / options.step_s),
        creep_(options.stiffness_damping_s / options.step_s) {
    if (creep_ > 0) damping_ = tangent_stiffness(body, materials, u_mm, Tangent::positive);
  }

  [[nodiscard]] double energy_uJ(const VectorXd& u_mm) const override {
    const VectorXd moved = u_mm - from_mm_;
    double energy = strain_energy_uJ(body_, materials_, u_mm) + surroundings_energy_uJ(body_, loads_.gas_kPa, u_mm) -
                    loads_.dead_mN.dot(u_mm) + 0.5 * inertia_ * mass_kg_.dot((u_mm - coasted_mm_).cwiseAbs2()) +
                    0.5 * drag_ * mass_kg_.dot(moved.cwiseAbs2());
    if (creep_ > 0) energy += 0.5 * creep_ * moved.dot(damped(moved));
    return energy;
  }
  [[nodiscard]] VectorXd force_mN(const VectorXd& u_mm) const override {
    const VectorXd moved = u_mm - from_mm_;
    VectorXd force = loads_.dead_mN + surroundings_force_mN(body_, loads_.gas_kPa, u_mm) -
                     internal_force_mN(body_, materials_, u_mm) -
                     mass_kg_.cwiseProduct(inertia_ * (u_mm - coasted_mm_) + drag_ * moved);
    if (creep_ > 0) force -= creep_ * damped(moved);
    return force;
  }
  [[nodiscard]] SparseMatrix<double> tangent(const VectorXd& u_mm, Tangent which) const override {
    SparseMatrix<double> sum = tangent_stiffness(body_, materials_, u_mm, which, loads_.gas_kPa);
    if (creep_ > 0) sum += creep_ * damping_;
    for (Eigen::Index i = 0; i < mass_kg_.size(); ++i) sum.coeffRef(i, i) += (inertia_ + drag_) * mass_kg_[i];
    return sum;
  }
  [[nodiscard]] double energy_scale_uJ(const VectorXd& u_mm) const override {
    return std::abs(loads_.dead_mN.dot(u_mm)) + std::abs(loads_.gas_kPa) * geometry::volume_mm3(body_.mesh) +
           0.5 * inertia_ * mass_kg_.dot((u_mm - coasted_mm_).cwiseAbs2());
  }
  // The forces that the step starts from: of the loads, of the deformation, and what would stop the motion in a step.
  [[nodiscard]] double scale_mN() const {
    const auto size = [&](const VectorXd& force) { return of_the_free(body_.resolved.held, force).norm(); };
    return size(loads_.dead_mN + surroundings_force_mN(body_, loads_.gas_kPa, from_mm_)) +
           size(internal_force_mN(body_, materials_, from_mm_)) +
           size(inertia_ * mass_kg_.cwiseProduct(coasted_mm_ - from_mm_));
  }

 private:
  [[nodiscard]] VectorXd damped(const VectorXd& moved) const {
    return damping_.selfadjointView<Eigen::Lower>() * moved;
  }

  const Body& body_;
  const std::vector<Material>& materials_;
  const AppliedLoads& loads_;
  const VectorXd& mass_kg_;
  VectorXd from_mm_, coasted_mm_;
  double inertia_, drag_, creep_;  // 1/s2
  SparseMatrix<double> damping_;   // lower triangle
};

}  // namespace

Result<NewtonMotion> NewtonMotion::create(Body body, std::vector<Material> materials, AppliedLoads loads,
                                          const MotionOptions& options) {
  GLISSON_ASSERT(body.options.order == ElementOrder::linear && materials.size() == body.mesh.cells.size());
  if (auto checked = check_motion_options(options); !checked) return failure(std::move(checked.error()));
  NewtonMotion motion;
  motion.body_ = std::move(body);
  motion.materials_ = std::move(materials);
  motion.loads_ = std::move(loads);
  motion.options_ = options;
  motion.mass_kg_ = lumped_mass_kg(motion.body_);
  motion.u_mm_ = VectorXd::Zero(motion.mass_kg_.size());
  motion.v_mm_s_ = motion.u_mm_;
  return motion;
}

Result<StepReport> NewtonMotion::step(const Progress& progress) {
  return step(loads_, [&](const Landscape& landscape, double scale_mN, const VectorXd& from_mm) {
    return descend(landscape, body_.resolved.held, scale_mN, from_mm,
                   {options_.relative_tolerance, options_.max_iterations, body_.options.memory_limit_bytes}, progress);
  });
}

Result<StepReport> NewtonMotion::step(const AppliedLoads& loads, const Settle& settle) {
  const Stopwatch watch;
  const StepLandscape landscape(body_, materials_, loads, options_, mass_kg_, u_mm_, v_mm_s_);
  auto descent = settle(landscape, landscape.scale_mN(), u_mm_);
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
  report.kinetic_energy_uJ = 0.5 * mass_kg_.dot(v_mm_s_.cwiseAbs2());
  report.step_ms = 1e3 * watch.seconds();
  return report;
}

void NewtonMotion::set_velocity(const VectorXd& velocity_mm_s) {
  v_mm_s_ = of_the_free(body_.resolved.held, velocity_mm_s);
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
