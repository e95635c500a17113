#include "mechanics/materials/stable_neo_hookean.h"

#include <cmath>
#include <Eigen/LU>

namespace glisson::mechanics {

StableNeoHookean::StableNeoHookean(const Lame& lame)
    : mu_kPa_(4.0 / 3.0 * lame.mu_kPa),
      lambda_kPa_(lame.lambda_kPa + 5.0 / 6.0 * lame.mu_kPa),
      alpha_(1.0 + 0.75 * mu_kPa_ / lambda_kPa_) {}

double StableNeoHookean::energy_density_kPa(const Eigen::Matrix3d& f) const {
  const auto energy = [&](double squared_norm, double j) {
    return 0.5 * mu_kPa_ * (squared_norm - 3.0 - std::log(squared_norm + 1.0)) +
           0.5 * lambda_kPa_ * (j - alpha_) * (j - alpha_);
  };
  return energy(f.squaredNorm(), f.determinant()) - energy(3.0, 1.0);
}

Eigen::Matrix3d StableNeoHookean::first_piola_kPa(const Eigen::Matrix3d& f) const {
  return mu_kPa_ * (1.0 - 1.0 / (f.squaredNorm() + 1.0)) * f +
         lambda_kPa_ * (f.determinant() - alpha_) * determinant_gradient(f);
}

Matrix9d StableNeoHookean::tangent_kPa(const Eigen::Matrix3d& f) const {
  const double above = f.squaredNorm() + 1.0;
  const Vector9d v = as_vector(f), g = as_vector(determinant_gradient(f));
  return mu_kPa_ * (1.0 - 1.0 / above) * Matrix9d::Identity() + 2.0 * mu_kPa_ / (above * above) * v * v.transpose() +
         lambda_kPa_ * g * g.transpose() + lambda_kPa_ * (f.determinant() - alpha_) * determinant_hessian(f);
}

StableNeoHookean StableNeoHookean::scaled(double factor) const {
  StableNeoHookean other = *this;
  other.mu_kPa_ *= factor;
  other.lambda_kPa_ *= factor;
  return other;
}

}  // namespace glisson::mechanics
