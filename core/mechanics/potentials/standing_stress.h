#pragma once
// A stress that is there whatever the deformation, and turns with it: a second Piola-Kirchhoff stress H in each sample
// of the cells (internal/cell_samples.h). Energy per rest volume H : (F^T F - I) / 2, first Piola-Kirchhoff stress F H.
// In a step of a relaxing body it is what is left of older stresses (dynamics/stress_history.h).

#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class StandingStress : public Potential {
 public:
  // kPa, symmetric: one a linear cell, four a quadratic one, in the cells' order. The body must outlive it.
  StandingStress(const Body& body, std::vector<Eigen::Matrix3d> stresses_kPa);

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  // `warped` has nothing of it, as of any stress that is there.
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const Body& body_;
  std::vector<Eigen::Matrix3d> stresses_kPa_;
};

}  // namespace glisson::mechanics
