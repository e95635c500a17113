#pragma once
// Self-contact of the faces of cuts: (max(0, p - k g)^2 - p^2) / (2 k) for each point and the triangle across from it
// (cut_self_contact.h).

#include <vector>

#include "mechanics/contact/internal/cut_self_contact.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class CutContactPotential : public Potential {
 public:
  // The contacts must outlive it.
  CutContactPotential(const std::vector<CutContact>& contacts, double k_mN_mm) : contacts_(contacts), k_(k_mN_mm) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const std::vector<CutContact>& contacts_;
  double k_;
};

// What the faces press with at one of them.
[[nodiscard]] double normal_force_mN(const CutContact& contact, double k_mN_mm, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
