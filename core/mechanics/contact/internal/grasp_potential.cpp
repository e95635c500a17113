#include "mechanics/contact/internal/grasp_potential.h"

namespace glisson::mechanics {

using Eigen::Vector3d;
using Eigen::VectorXd;

double GraspPotential::energy_uJ(const VectorXd& u_mm) const {
  double sum_uJ = 0;
  for (const PrescribedPatch& patch : patches_) {
    sum_uJ += (patch.pull_mN(k_, u_mm).squaredNorm() - patch.multiplier_mN.squaredNorm()) / (2 * k_);
  }
  return sum_uJ;
}

void GraspPotential::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  for (const PrescribedPatch& patch : patches_) {
    const Vector3d pull_mN = patch.pull_mN(k_, u_mm);
    for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
      force_mN.segment<3>(3 * patch.nodes[i]) += patch.weights[i] * pull_mN;
    }
  }
}

void GraspPotential::add_tangent(const VectorXd& /*u_mm*/, Tangent /*which*/, TangentSum& sum) const {
  for (const PrescribedPatch& patch : patches_) {
    for (std::size_t a = 0; a < patch.nodes.size(); ++a) {
      for (std::size_t b = 0; b < patch.nodes.size(); ++b) {
        sum.add(patch.nodes[a], patch.nodes[b], k_ * patch.weights[a] * patch.weights[b] * Eigen::Matrix3d::Identity());
      }
    }
  }
}

double GraspPotential::scale_uJ(const VectorXd& /*u_mm*/) const {
  double scale_uJ = 0;
  for (const PrescribedPatch& patch : patches_) scale_uJ += patch.multiplier_mN.squaredNorm() / k_;
  return scale_uJ;
}

Vector3d PrescribedPatch::off_mm(const VectorXd& u_mm) const {
  Vector3d mean_mm = Vector3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) mean_mm += weights[i] * u_mm.segment<3>(3 * nodes[i]);
  return mean_mm - wanted_mm;
}

}  // namespace glisson::mechanics
