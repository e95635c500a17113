#include "mechanics/dynamics/internal/implicit_step.h"

#include "mechanics/potentials/elastic.h"
#include "mechanics/potentials/quadratic.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {
using Eigen::VectorXd;

ImplicitStep::ImplicitStep(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                           const DynamicsOptions& options, const Eigen::SparseMatrix<double>& mass_kg,
                           const VectorXd& u_mm, const VectorXd& v_mm_s, const Potentials& besides)
    : potential_(body, static_potentials(body, materials, loads)) {
  const double h = options.step_s;
  const auto inertia = std::make_shared<QuadraticPotential>(1 / (h * h), mass_kg, u_mm + h * v_mm_s);
  const auto size_mN = [&](const VectorXd& force_mN) { return free_values(body.resolved.fixed, force_mN).norm(); };
  scale_mN_ = size_mN(force_mN(boundary_and_loads(body, loads), u_mm)) +
              size_mN(internal_force_mN(body, materials, u_mm)) + size_mN(force_mN({inertia}, u_mm));

  Potentials of_motion = besides;
  of_motion.push_back(inertia);
  if (options.mass_damping_per_s > 0) {
    of_motion.push_back(std::make_shared<QuadraticPotential>(options.mass_damping_per_s / h, mass_kg, u_mm));
  }
  if (options.stiffness_damping_s > 0) {
    stiffness_ = TotalPotential(body, elastic_potentials(body, materials, 0.0)).tangent(u_mm, Tangent::positive);
    of_motion.push_back(std::make_shared<QuadraticPotential>(options.stiffness_damping_s / h, stiffness_, u_mm));
  }
  potential_ = potential_.with(of_motion);
}

}  // namespace glisson::mechanics
