#include "mechanics/materials/anisotropy.h"

#include <fmt/format.h>
#include <cmath>

#include "base/dense.h"
#include "mechanics/materials/small_strain.h"

namespace glisson::mechanics {
namespace {

Matrix9d normal_tangent(const TransverseIsotropy& anisotropy, double poisson_ratio);
Matrix9d shear_along(const Eigen::Vector3d& axis);
Matrix9d inverse_on_symmetric(const Matrix9d& compliance);

}  // namespace

Result<void> check_anisotropy(const TransverseIsotropy& anisotropy, double poisson_ratio) {
  if (!anisotropy.axis.allFinite() || anisotropy.axis.norm() < 1e-12 || !std::isfinite(anisotropy.ratio) ||
      anisotropy.ratio <= 0 || !std::isfinite(anisotropy.shear_ratio) || anisotropy.shear_ratio <= 0) {
    return failure("grain-invalid", GLISSON_TEXT("A grain needs an axis of some length and a ratio above zero."));
  }
  const SymmetricModes modes = symmetric_modes(unit_tangent(anisotropy, poisson_ratio));
  // Three of the nine are rotations, which cost nothing.
  if (modes.values[0] > -1e-9 && modes.values[3] > 1e-9) return {};
  return failure("grain-invalid",
                 GLISSON_TEXT("With a ratio of {0} along the grain no stable material is left at a Poisson's ratio of "
                              "{1}."),
                 {fmt::format("{:g}", anisotropy.ratio), fmt::format("{:g}", poisson_ratio)});
}

Matrix9d unit_tangent(const TransverseIsotropy& anisotropy, double poisson_ratio) {
  const Matrix9d tangent = normal_tangent(anisotropy, poisson_ratio);
  if (anisotropy.shear_ratio == 1.0) return tangent;
  return tangent + (anisotropy.shear_ratio - 1.0) / (1.0 + poisson_ratio) * shear_along(anisotropy.axis.normalized());
}

namespace {

// With the isotropic shear moduli.
Matrix9d normal_tangent(const TransverseIsotropy& anisotropy, double poisson_ratio) {
  const Matrix9d isotropic = isotropic_tangent_kPa(lame_from_youngs(1.0, poisson_ratio));
  if (anisotropy.ratio == 1.0) return isotropic;
  const Eigen::Vector3d axis = anisotropy.axis.normalized();
  const Vector9d along = as_vector(axis * axis.transpose());
  if (anisotropy.law == AnisotropyLaw::fibres) return isotropic + (anisotropy.ratio - 1.0) * along * along.transpose();
  const Vector9d identity = as_vector(Eigen::Matrix3d::Identity());
  const Vector9d across = identity - along;
  const Matrix9d change =
      poisson_ratio * (along * across.transpose() + across * along.transpose()) - along * along.transpose();
  const Matrix9d compliance = (1.0 + poisson_ratio) * Matrix9d::Identity() -
                              poisson_ratio * identity * identity.transpose() + (1.0 - 1.0 / anisotropy.ratio) * change;
  return inverse_on_symmetric(compliance);
}

// Takes of a tensor its symmetric part that shears planes along the axis.
Matrix9d shear_along(const Eigen::Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Eigen::Vector3d first = axis.cross(Eigen::Vector3d::Unit(smallest)).normalized(), second = axis.cross(first);
  Matrix9d sum = Matrix9d::Zero();
  for (const Eigen::Vector3d& across : {first, second}) {
    const Vector9d shear = std::sqrt(0.5) * as_vector(axis * across.transpose() + across * axis.transpose());
    sum += shear * shear.transpose();
  }
  return sum;
}

// The stiffness whose inverse, on symmetric tensors, is the compliance.
Matrix9d inverse_on_symmetric(const Matrix9d& compliance) {
  Eigen::Matrix<double, 9, 6> basis = Eigen::Matrix<double, 9, 6>::Zero();
  int column = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++column) {
      basis(i + 3 * j, column) += i == j ? 0.5 : std::sqrt(0.5);
      basis(j + 3 * i, column) += i == j ? 0.5 : std::sqrt(0.5);
    }
  }
  const Eigen::Matrix<double, 6, 6> inverse = dense_inverse(basis.transpose() * compliance * basis);
  return basis * inverse * basis.transpose();
}

}  // namespace
}  // namespace glisson::mechanics
