#include "mechanics/materials/deformation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace glisson::mechanics {
Polar polar_decomposition(const Eigen::Matrix3d& f) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  Eigen::Vector3d stretches = svd.singularValues();
  if (u.determinant() * svd.matrixV().determinant() < 0) {
    u.col(2) *= -1.0;
    stretches[2] *= -1.0;
  }
  return {u * svd.matrixV().transpose(), svd.matrixV() * stretches.asDiagonal() * svd.matrixV().transpose()};
}

Matrix9d rotation_derivative(const Polar& polar) {
  // dR = R W with W skew; the skew part of R^T dF = W S + dS gives (tr(S) I - S) w = axis(R^T dF - dF^T R).
  const Eigen::Matrix3d& r = polar.rotation;
  const Eigen::Matrix3d sums = polar.stretch.trace() * Eigen::Matrix3d::Identity() - polar.stretch;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(sums);
  const Eigen::Vector3d inverse_sums = modes.eigenvalues().cwiseMax(1e-3).cwiseInverse();
  const Eigen::Matrix3d inverse = modes.eigenvectors() * inverse_sums.asDiagonal() * modes.eigenvectors().transpose();
  Matrix9d derivative;
  for (int k = 0; k < 9; ++k) {
    const Eigen::Matrix3d a = r.transpose() * as_matrix(Vector9d::Unit(k));
    const Eigen::Vector3d axis(a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1));
    derivative.col(k) = as_vector(r * cross_matrix(inverse * axis));
  }
  return derivative;
}

Matrix9d determinant_hessian(const Eigen::Matrix3d& f) {
  // Column c of the gradient is f_(c+1) x f_(c+2).
  Matrix9d hessian = Matrix9d::Zero();
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, last = (c + 2) % 3;
    hessian.block<3, 3>(3 * c, 3 * next) = -cross_matrix(f.col(last));
    hessian.block<3, 3>(3 * c, 3 * last) = cross_matrix(f.col(next));
  }
  return hessian;
}

namespace {

template <int size>
Eigen::Matrix<double, size, size> without_negative_modes(const Eigen::Matrix<double, size, size>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> modes(symmetric);
  if (modes.eigenvalues().minCoeff() >= 0) return symmetric;
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0.0).asDiagonal() * modes.eigenvectors().transpose();
}

}  // namespace

Matrix9d positive_part(const Matrix9d& symmetric) { return without_negative_modes<9>(symmetric); }

Eigen::Matrix<double, 6, 6> positive_part(const Eigen::Matrix<double, 6, 6>& symmetric) {
  return without_negative_modes<6>(symmetric);
}

}  // namespace glisson::mechanics
