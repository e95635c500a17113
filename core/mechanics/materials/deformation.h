#pragma once
// The calculus of the deformation gradient F that the materials share. A 3x3 matrix is seen as a vector of nine, column
// after column. So the derivative of one matrix by another is 9x9.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace glisson::mechanics {

using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;

inline Vector9d as_vector(const Eigen::Matrix3d& m) { return Eigen::Map<const Vector9d>(m.data()); }
inline Eigen::Matrix3d as_matrix(const Vector9d& v) { return Eigen::Map<const Eigen::Matrix3d>(v.data()); }

// The matrix of v x.
inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// F = R S with R a rotation (never a reflection) and S symmetric. Where F inverts, the smallest eigenvalue of S is
// negative (Irving, Teran, Fedkiw 2004, Invertible Finite Elements). The slow, sure way: by singular values.
struct Polar {
  Eigen::Matrix3d rotation;
  Eigen::Matrix3d stretch;
};
[[nodiscard]] Polar polar_decomposition(const Eigen::Matrix3d& f);

// dR/dF: how the rotation turns as F changes. Where two stretches sum to almost nothing (deep in inversion) R is not
// differentiable, and the derivative is bounded instead.
[[nodiscard]] Matrix9d rotation_derivative(const Polar& polar);

// det F by F (the cofactor matrix), and its second derivative.
[[nodiscard]] inline Eigen::Matrix3d determinant_gradient(const Eigen::Matrix3d& f) {
  Eigen::Matrix3d gradient;
  for (int c = 0; c < 3; ++c) gradient.col(c) = f.col((c + 1) % 3).cross(f.col((c + 2) % 3));
  return gradient;
}
[[nodiscard]] Matrix9d determinant_hessian(const Eigen::Matrix3d& f);

// The nearest positive semi-definite matrix to a symmetric one: negative eigenvalues become zero.
[[nodiscard]] Matrix9d positive_part(const Matrix9d& symmetric);
[[nodiscard]] Eigen::Matrix<double, 6, 6> positive_part(const Eigen::Matrix<double, 6, 6>& symmetric);

}  // namespace glisson::mechanics
