#include "base/dense.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace glisson {

SymmetricModes symmetric_modes(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(symmetric);
  return {modes.eigenvalues(), modes.eigenvectors()};
}

Eigen::MatrixXd leading_vectors(const Eigen::MatrixXd& symmetric, double negligible_share) {
  const SymmetricModes modes = symmetric_modes(symmetric);
  const Eigen::Index all = modes.values.size();
  Eigen::Index kept = all;
  double left_out = 0;
  while (kept > 1 && left_out + modes.values[all - kept] < negligible_share * modes.values.sum()) {
    left_out += modes.values[all - kept--];
  }
  return modes.vectors.rightCols(kept);
}

RightSingular right_singular(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& square) { return square.partialPivLu().inverse(); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

}  // namespace glisson
