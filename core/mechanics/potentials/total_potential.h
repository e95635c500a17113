#pragma once
// A body's potential energy: the sum of its terms, whose minimum is an equilibrium or a step in time.

#include "mechanics/elements/body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/materials/material.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class TotalPotential : public Objective {
 public:
  // Over the nodes of the body, which must outlive it.
  TotalPotential(const Body& body, Potentials terms) : body_(&body), terms_(std::move(terms)) {}
  // The same with more terms.
  [[nodiscard]] TotalPotential with(const Potentials& more) const;

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& u_mm) const override;
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& u_mm, Tangent which) const override;
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const Body* body_;
  Potentials terms_;
};

// What stands around a body: its foundations, ligaments and capsule, and gas at `pressure_kPa` (terms that are not
// there are left out). What is named must outlive the terms, here and below.
[[nodiscard]] Potentials boundary_potentials(const Body& body, double pressure_kPa);
// What is around it, and the loads.
[[nodiscard]] Potentials boundary_and_loads(const Body& body, const AppliedLoads& loads);
// What is around it, and its material.
[[nodiscard]] Potentials elastic_potentials(const Body& body, const std::vector<Material>& materials,
                                            double pressure_kPa);
// All of these.
[[nodiscard]] Potentials static_potentials(const Body& body, const std::vector<Material>& materials,
                                           const AppliedLoads& loads);

}  // namespace glisson::mechanics
