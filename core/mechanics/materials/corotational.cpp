#include "mechanics/materials/corotational.h"

#include "mechanics/materials/small_strain.h"

namespace glisson::mechanics {

double Corotational::energy_density_kPa(const Eigen::Matrix3d& f) const {
  return mechanics::energy_density_kPa(lame, polar_decomposition(f).stretch - Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d Corotational::first_piola_kPa(const Eigen::Matrix3d& f) const {
  const Polar polar = polar_decomposition(f);
  return 2.0 * lame.mu_kPa * (f - polar.rotation) + lame.lambda_kPa * (polar.stretch.trace() - 3.0) * polar.rotation;
}

Matrix9d Corotational::tangent_kPa(const Eigen::Matrix3d& f) const {
  const Polar polar = polar_decomposition(f);
  const Vector9d r = as_vector(polar.rotation);
  const double turning_kPa = lame.lambda_kPa * (polar.stretch.trace() - 3.0) - 2.0 * lame.mu_kPa;
  return 2.0 * lame.mu_kPa * Matrix9d::Identity() + lame.lambda_kPa * r * r.transpose() +
         turning_kPa * rotation_derivative(polar);
}

Matrix9d Corotational::warped_tangent_kPa(const Eigen::Matrix3d& f) const {
  const Eigen::Matrix3d rotation = polar_decomposition(f).rotation;
  Matrix9d turn = Matrix9d::Zero();
  for (int c = 0; c < 3; ++c) turn.block<3, 3>(3 * c, 3 * c) = rotation;
  return turn * isotropic_tangent_kPa(lame) * turn.transpose();
}

}  // namespace glisson::mechanics
