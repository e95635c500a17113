#pragma once
// One step of implicit Euler as the potential energy whose minimum it is: newton_implicit_euler.h says which. Inside of
// this room.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/materials/material.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {

class IncrementalPotential : public Potential {
 public:
  // From u, moving with v. `mass_kg` is the lower triangle of the mass over the nodes, lumped or not.
  IncrementalPotential(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                       const DynamicsOptions& options, const Eigen::SparseMatrix<double>& mass_kg,
                       const Eigen::VectorXd& u_mm, const Eigen::VectorXd& v_mm_s);

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& u_mm) const override;
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& u_mm, Tangent which) const override;
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& u_mm) const override;
  // The forces that the step starts from: of the loads, of the deformation, and what would stop the motion in a step.
  [[nodiscard]] double scale_mN() const;

 private:
  const Body& body_;
  const std::vector<Material>& materials_;
  const AppliedLoads& loads_;
  const Eigen::SparseMatrix<double>& mass_kg_;
  Eigen::VectorXd from_mm_, coasted_mm_;
  double inertia_, drag_, creep_;          // 1/s2
  Eigen::SparseMatrix<double> stiffness_;  // that creeps; lower triangle
};

}  // namespace glisson::mechanics
