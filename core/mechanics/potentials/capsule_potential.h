#pragma once
// The organ's capsule: a membrane over the whole boundary with an energy per area of rest (materials/capsule.h).

#include "mechanics/elements/body.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class CapsulePotential : public Potential {
 public:
  // Of the body's `options.capsule`, which must be there; the body must outlive it.
  explicit CapsulePotential(const Body& body) : body_(body) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  // All but the exact one leave out what of the capsule curves down.
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  // Its energy is a difference of numbers of the size of its stiffness times its area.
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const Body& body_;
};

}  // namespace glisson::mechanics
