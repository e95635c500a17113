#include "mechanics/materials/capsule.h"

#include <Eigen/LU>
#include <limits>

namespace glisson::mechanics {
namespace {

double scale(const Capsule& capsule) { return capsule.thickness_mm * capsule.youngs_modulus_kPa / 3.0; }

}  // namespace

double energy_per_area(const Capsule& capsule, const Matrix32d& f) {
  const Eigen::Matrix2d c = f.transpose() * f;
  const double det = c.determinant();
  if (!(det > 0)) return std::numeric_limits<double>::infinity();
  return 0.5 * scale(capsule) * (c.trace() + 1.0 / det - 3.0);
}

Matrix32d membrane_stress(const Capsule& capsule, const Matrix32d& f) {
  const Eigen::Matrix2d c = f.transpose() * f;
  return scale(capsule) * (f - f * c.inverse() / c.determinant());
}

Matrix6d membrane_tangent(const Capsule& capsule, const Matrix32d& f) {
  const Eigen::Matrix2d c = f.transpose() * f, inverse = c.inverse();
  const double det = c.determinant();
  Matrix6d tangent;
  for (int k = 0; k < 6; ++k) {
    Matrix32d d = Matrix32d::Zero();
    d(k % 3, k / 3) = 1.0;
    const Eigen::Matrix2d change = inverse * (d.transpose() * f + f.transpose() * d);  // C^-1 dC
    const Matrix32d slope = d - (d * inverse - f * change * inverse - change.trace() * f * inverse) / det;
    tangent.col(k) = scale(capsule) * Eigen::Map<const Vector6d>(slope.data());
  }
  return tangent;
}

}  // namespace glisson::mechanics
