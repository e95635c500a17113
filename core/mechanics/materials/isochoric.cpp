#include "mechanics/materials/isochoric.h"

#include <cmath>
#include <Eigen/LU>
#include <limits>

namespace glisson::mechanics {
namespace {

// w and its derivatives by the two invariants. No law here has a mixed or a second derivative by I2.
struct Shape {
  double w, by_i1, by_i2, by_i1_twice;
};
Shape shape_of(const NeoHookean& law, double i1);
Shape shape_of(const VerondaWestmann& law, double i1, double i2);

struct Invariants {
  double j, i1, i2;             // the last two freed of the volume
  double squared_norm, second;  // and as they are: |F|^2 and (|F|^4 - |F^T F|^2) / 2
  double shrink_i1, shrink_i2;  // J^(-2/3), J^(-4/3)
};
Invariants invariants_of(const Eigen::Matrix3d& f);

double energy(const Shape& shape, double bulk_kPa, const Invariants& at);
Eigen::Matrix3d stress(const Shape& shape, double bulk_kPa, const Invariants& at, const Eigen::Matrix3d& f);
Matrix9d tangent(const Shape& shape, double bulk_kPa, const Invariants& at, const Eigen::Matrix3d& f);

}  // namespace

double NeoHookean::energy_density_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return energy(shape_of(*this, at.i1), bulk_kPa, at);
}
Eigen::Matrix3d NeoHookean::first_piola_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return stress(shape_of(*this, at.i1), bulk_kPa, at, f);
}
Matrix9d NeoHookean::tangent_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return tangent(shape_of(*this, at.i1), bulk_kPa, at, f);
}

double VerondaWestmann::energy_density_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return energy(shape_of(*this, at.i1, at.i2), bulk_kPa, at);
}
Eigen::Matrix3d VerondaWestmann::first_piola_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return stress(shape_of(*this, at.i1, at.i2), bulk_kPa, at, f);
}
Matrix9d VerondaWestmann::tangent_kPa(const Eigen::Matrix3d& f) const {
  const Invariants at = invariants_of(f);
  return tangent(shape_of(*this, at.i1, at.i2), bulk_kPa, at, f);
}

namespace {

Shape shape_of(const NeoHookean& law, double i1) {
  return {0.5 * law.shear_kPa * (i1 - 3.0), 0.5 * law.shear_kPa, 0, 0};
}

Shape shape_of(const VerondaWestmann& law, double i1, double i2) {
  const double growth = std::exp(law.stiffening * (i1 - 3.0));
  return {law.shear_kPa / law.stiffening * (growth - 1.0) - 0.5 * law.shear_kPa * (i2 - 3.0), law.shear_kPa * growth,
          -0.5 * law.shear_kPa, law.shear_kPa * law.stiffening * growth};
}

Invariants invariants_of(const Eigen::Matrix3d& f) {
  Invariants at{};
  at.j = f.determinant();
  at.squared_norm = f.squaredNorm();
  at.second = 0.5 * (at.squared_norm * at.squared_norm - (f.transpose() * f).squaredNorm());
  at.shrink_i1 = 1.0 / std::cbrt(at.j * at.j);
  at.shrink_i2 = at.shrink_i1 * at.shrink_i1;
  at.i1 = at.shrink_i1 * at.squared_norm;
  at.i2 = at.shrink_i2 * at.second;
  return at;
}

double energy(const Shape& shape, double bulk_kPa, const Invariants& at) {
  if (!(at.j > 0)) return std::numeric_limits<double>::infinity();
  return shape.w + 0.5 * bulk_kPa * (at.j - 1.0) * (at.j - 1.0);
}

// An invariant J^a I has the gradient J^a (dI + a I / J dJ); here a = -2/3 and -4/3.
struct Gradients {
  Vector9d j, plain_i1, plain_i2, i1;

  Gradients(const Invariants& at, const Eigen::Matrix3d& f)
      : j(as_vector(determinant_gradient(f))),
        plain_i1(as_vector(2.0 * f)),
        plain_i2(as_vector(2.0 * (at.squared_norm * f - f * f.transpose() * f))),
        i1(at.shrink_i1 * (plain_i1 - 2.0 / 3.0 * at.squared_norm / at.j * j)) {}
  [[nodiscard]] Vector9d i2(const Invariants& at) const {
    return at.shrink_i2 * (plain_i2 - 4.0 / 3.0 * at.second / at.j * j);
  }
};

Eigen::Matrix3d stress(const Shape& shape, double bulk_kPa, const Invariants& at, const Eigen::Matrix3d& f) {
  const Gradients by_f(at, f);
  return as_matrix(shape.by_i1 * by_f.i1 + shape.by_i2 * by_f.i2(at) + bulk_kPa * (at.j - 1.0) * by_f.j);
}

// The second derivative of J^a I.
Matrix9d freed_hessian(double shrink, double a, double plain, const Vector9d& gradient, const Matrix9d& hessian,
                       double j, const Vector9d& j_gradient, const Matrix9d& j_hessian) {
  return shrink * (hessian + a / j * (gradient * j_gradient.transpose() + j_gradient * gradient.transpose()) +
                   a * (a - 1.0) * plain / (j * j) * j_gradient * j_gradient.transpose() + a * plain / j * j_hessian);
}

// The second derivative of (|F|^4 - |F^T F|^2) / 2.
Matrix9d second_invariant_hessian(double squared_norm, const Eigen::Matrix3d& f) {
  const Vector9d v = as_vector(f);
  Matrix9d hessian = 4.0 * v * v.transpose() + 2.0 * squared_norm * Matrix9d::Identity();
  const Eigen::Matrix3d right = f.transpose() * f, left = f * f.transpose();
  for (int k = 0; k < 9; ++k) {
    const Eigen::Matrix3d d = as_matrix(Vector9d::Unit(k));
    hessian.col(k) -= 2.0 * as_vector(d * right + f * d.transpose() * f + left * d);
  }
  return hessian;
}

Matrix9d tangent(const Shape& shape, double bulk_kPa, const Invariants& at, const Eigen::Matrix3d& f) {
  const Gradients by_f(at, f);
  const Matrix9d j_hessian = determinant_hessian(f);
  Matrix9d sum = shape.by_i1_twice * by_f.i1 * by_f.i1.transpose() +
                 shape.by_i1 * freed_hessian(at.shrink_i1, -2.0 / 3.0, at.squared_norm, by_f.plain_i1,
                                             2.0 * Matrix9d::Identity(), at.j, by_f.j, j_hessian) +
                 bulk_kPa * (by_f.j * by_f.j.transpose() + (at.j - 1.0) * j_hessian);
  if (shape.by_i2 != 0) {
    sum += shape.by_i2 * freed_hessian(at.shrink_i2, -4.0 / 3.0, at.second, by_f.plain_i2,
                                       second_invariant_hessian(at.squared_norm, f), at.j, by_f.j, j_hessian);
  }
  return sum;
}

}  // namespace
}  // namespace glisson::mechanics
