#pragma once
// Places of the surface that rods of tools press on: (max(0, p - k g)^2 - p^2) / (2 k) and friction, as
// large_contact.h says.

#include <vector>

#include "mechanics/contact/internal/contact_constraint.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class ToolContactPotential : public Potential {
 public:
  // The constraints must outlive it.
  explicit ToolContactPotential(const std::vector<ContactConstraint>& constraints) : constraints_(constraints) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const std::vector<ContactConstraint>& constraints_;
};

// What one of them presses with along its normal.
[[nodiscard]] double normal_force_mN(const ContactConstraint& constraint, const Gap& gap);

}  // namespace glisson::mechanics
