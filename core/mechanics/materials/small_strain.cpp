#include "mechanics/materials/small_strain.h"

namespace glisson::mechanics {

double SmallStrain::energy_density_kPa(const Eigen::Matrix3d& f) const {
  return mechanics::energy_density_kPa(lame, small_strain(f - Eigen::Matrix3d::Identity()));
}

Eigen::Matrix3d SmallStrain::first_piola_kPa(const Eigen::Matrix3d& f) const {
  return stress_kPa(lame, small_strain(f - Eigen::Matrix3d::Identity()));
}

Matrix9d SmallStrain::tangent_kPa(const Eigen::Matrix3d&) const { return isotropic_tangent_kPa(lame); }

Matrix9d isotropic_tangent_kPa(const Lame& lame) {
  Matrix9d tangent = lame.mu_kPa * Matrix9d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) tangent(r + 3 * c, c + 3 * r) += lame.mu_kPa;
  }
  const Vector9d identity = as_vector(Eigen::Matrix3d::Identity());
  return tangent + lame.lambda_kPa * identity * identity.transpose();
}

}  // namespace glisson::mechanics
