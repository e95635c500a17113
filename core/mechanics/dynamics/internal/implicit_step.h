#pragma once
// One step of implicit Euler as the potential energy whose minimum it is: newton_implicit_euler.h says which.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/potentials/total_potential.h"

namespace glisson::mechanics {

class ImplicitStep {
 public:
  // From u, moving with v. `mass_kg` is the lower triangle of the mass over the nodes, lumped or not. `besides` are
  // terms more that act. What is named must outlive it.
  ImplicitStep(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
               const DynamicsOptions& options, const Eigen::SparseMatrix<double>& mass_kg, const Eigen::VectorXd& u_mm,
               const Eigen::VectorXd& v_mm_s, const Potentials& besides = {});
  ImplicitStep(const ImplicitStep&) = delete;  // its terms name its stiffness
  ImplicitStep& operator=(const ImplicitStep&) = delete;

  [[nodiscard]] const TotalPotential& potential() const { return potential_; }
  // The forces that the step starts from: of the loads, of the deformation, and what would stop the motion in a step.
  [[nodiscard]] double scale_mN() const { return scale_mN_; }

 private:
  Eigen::SparseMatrix<double> stiffness_;  // that damps; lower triangle
  TotalPotential potential_;
  double scale_mN_ = 0;
};

}  // namespace glisson::mechanics
