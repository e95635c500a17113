#include "mechanics/contact/internal/cut_contact_potential.h"

#include <algorithm>

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

double CutContactPotential::energy_uJ(const VectorXd& u_mm) const {
  double sum_uJ = 0;
  for (const CutContact& contact : contacts_) {
    const double force = normal_force_mN(contact, k_, u_mm);
    sum_uJ += (force * force - contact.multiplier_mN * contact.multiplier_mN) / (2 * k_);
  }
  return sum_uJ;
}

void CutContactPotential::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  for (const CutContact& contact : contacts_) {
    const Vector3d force = normal_force_mN(contact, k_, u_mm) * contact.normal;
    for (const auto& [node, share] : contact.shares()) force_mN.segment<3>(3 * node) += share * force;
  }
}

void CutContactPotential::add_tangent(const VectorXd& u_mm, Tangent /*which*/, TangentSum& sum) const {
  for (const CutContact& contact : contacts_) {
    if (normal_force_mN(contact, k_, u_mm) == 0) continue;
    const Matrix3d block = k_ * contact.normal * contact.normal.transpose();
    for (const auto& [a, a_share] : contact.shares()) {
      for (const auto& [b, b_share] : contact.shares()) sum.add(a, b, a_share * b_share * block);
    }
  }
}

double CutContactPotential::scale_uJ(const VectorXd& /*u_mm*/) const {
  double scale_uJ = 0;
  for (const CutContact& contact : contacts_) scale_uJ += contact.multiplier_mN * contact.multiplier_mN / k_;
  return scale_uJ;
}

double normal_force_mN(const CutContact& contact, double k_mN_mm, const VectorXd& u_mm) {
  return std::max(0.0, contact.multiplier_mN - k_mN_mm * contact.gap_mm(u_mm));
}

}  // namespace glisson::mechanics
