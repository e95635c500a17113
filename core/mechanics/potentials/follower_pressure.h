#pragma once
// Gas at constant pressure p around a closed body, the pneumoperitoneum's: p V, V the body's volume (e.g. Bonet and
// Wood, 8.5). The integrals over faces are exact for linear and quadratic faces.

#include "mechanics/elements/body.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class FollowerPressure : public Potential {
 public:
  // On the whole boundary; the body must outlive it.
  FollowerPressure(const Body& body, double pressure_kPa) : body_(body), pressure_kPa_(pressure_kPa) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;  // 0 at rest
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  // Nothing but to the exact one.
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const Body& body_;
  double pressure_kPa_;
};

}  // namespace glisson::mechanics
