#include "mechanics/contact/internal/tool_contact_potential.h"

#include <algorithm>

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

double ToolContactPotential::energy_uJ(const VectorXd& u_mm) const {
  double sum_uJ = 0;
  for (const ContactConstraint& constraint : constraints_) {
    const double force = normal_force_mN(constraint, gap_of(constraint, u_mm));
    sum_uJ += (force * force - constraint.multiplier_mN * constraint.multiplier_mN) / (2 * constraint.k_mN_mm) +
              friction_force_of(constraint, u_mm).energy_uJ;
  }
  return sum_uJ;
}

void ToolContactPotential::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  for (const ContactConstraint& constraint : constraints_) {
    const Gap gap = gap_of(constraint, u_mm);
    const Vector3d force = normal_force_mN(constraint, gap) * gap.normal + friction_force_of(constraint, u_mm).force_mN;
    for (int i = 0; i < 6; ++i) force_mN.segment<3>(3 * constraint.nodes[i]) += constraint.weights[i] * force;
  }
}

void ToolContactPotential::add_tangent(const VectorXd& u_mm, Tangent which, TangentSum& sum) const {
  for (const ContactConstraint& constraint : constraints_) {
    const Gap gap = gap_of(constraint, u_mm);
    const double force = normal_force_mN(constraint, gap);
    if (force == 0 && constraint.friction_limit_mN == 0) continue;
    Matrix3d block = friction_force_of(constraint, u_mm).stiffness;
    if (force > 0) block += constraint.k_mN_mm * gap.normal * gap.normal.transpose();
    if (force > 0 && which == Tangent::exact) block -= force * gap.bend;
    for (int a = 0; a < 6; ++a) {
      for (int b = 0; b < 6; ++b) {
        sum.add(constraint.nodes[a], constraint.nodes[b], constraint.weights[a] * constraint.weights[b] * block);
      }
    }
  }
}

double ToolContactPotential::scale_uJ(const VectorXd& /*u_mm*/) const {
  double scale_uJ = 0;
  for (const ContactConstraint& constraint : constraints_) {
    scale_uJ += (constraint.multiplier_mN * constraint.multiplier_mN + constraint.friction_mN.squaredNorm()) /
                constraint.k_mN_mm;
  }
  return scale_uJ;
}

double normal_force_mN(const ContactConstraint& constraint, const Gap& gap) {
  return std::max(0.0, constraint.multiplier_mN - constraint.k_mN_mm * gap.mm);
}

}  // namespace glisson::mechanics
