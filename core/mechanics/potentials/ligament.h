#pragma once
// Ligaments: fans of springs to fixed anchors that pull once they are taut and never push, k max(0, l - l0)^2 / 2.

#include "mechanics/elements/body.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class LigamentPotential : public Potential {
 public:
  // Of the body's resolved ligaments; the body must outlive it.
  explicit LigamentPotential(const Body& body) : body_(body) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;

 private:
  const Body& body_;
};

}  // namespace glisson::mechanics
