#include "mechanics/potentials/ligament.h"

#include <algorithm>

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Pull {
  double beyond_mm;  // how far the spring is longer than what it gives for nothing; below 0 where it is slack
  double length_mm;
  Vector3d towards_anchor;
};
Pull pull_of(const Body& body, const LigamentSpring& spring, const VectorXd& u_mm);

}  // namespace

double LigamentPotential::energy_uJ(const VectorXd& u_mm) const {
  double sum_uJ = 0;
  for (const LigamentSpring& spring : body_.resolved.ligaments) {
    const double beyond_mm = std::max(0.0, pull_of(body_, spring, u_mm).beyond_mm);
    sum_uJ += 0.5 * spring.stiffness_mN_per_mm * beyond_mm * beyond_mm;
  }
  return sum_uJ;
}

void LigamentPotential::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  for (const LigamentSpring& spring : body_.resolved.ligaments) {
    const Pull pull = pull_of(body_, spring, u_mm);
    if (pull.beyond_mm <= 0) continue;
    force_mN.segment<3>(3 * spring.node) += spring.stiffness_mN_per_mm * pull.beyond_mm * pull.towards_anchor;
  }
}

void LigamentPotential::add_tangent(const VectorXd& u_mm, Tangent /*which*/, TangentSum& sum) const {
  for (const LigamentSpring& spring : body_.resolved.ligaments) {
    const auto [beyond_mm, length_mm, along] = pull_of(body_, spring, u_mm);
    // At the very edge of slackness the tangent is that of the pull: a body that is about to hang must not fly.
    if (beyond_mm < 0 || length_mm == 0) continue;
    const Matrix3d axial = along * along.transpose();
    sum.within_cells().add(
        spring.node, spring.node,
        spring.stiffness_mN_per_mm * (axial + beyond_mm / length_mm * (Matrix3d::Identity() - axial)));
  }
}

namespace {

Pull pull_of(const Body& body, const LigamentSpring& spring, const VectorXd& u_mm) {
  const Vector3d arm_mm = spring.anchor_mm - body.layout.positions_mm[spring.node] - u_mm.segment<3>(3 * spring.node);
  const double length_mm = arm_mm.norm();
  if (length_mm == 0) return {0, 0, Vector3d::Zero()};
  // Rounding at rest must not decide between taut and slack.
  const double beyond_mm = length_mm - spring.free_length_mm;
  return {beyond_mm > -1e-12 * length_mm ? std::max(0.0, beyond_mm) : -1.0, length_mm, arm_mm / length_mm};
}

}  // namespace
}  // namespace glisson::mechanics
