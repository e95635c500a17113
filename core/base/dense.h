#pragma once
// Decompositions of dense matrices of any size, compiled once here. Wherever one of Eigen's of a fixed size beyond four
// is used, it takes the compiler some ten seconds. Not for inner loops: they allocate.

#include <Eigen/Core>

namespace glisson {

// Eigenvalues of a symmetric matrix, ascending, and its orthonormal eigenvectors as columns in their order.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
[[nodiscard]] SymmetricModes symmetric_modes(const Eigen::MatrixXd& symmetric);

// The eigenvectors of the largest eigenvalues of a positive semidefinite matrix, ascending: all but those whose values
// sum up to less than `negligible_share` of all; one at least.
[[nodiscard]] Eigen::MatrixXd leading_vectors(const Eigen::MatrixXd& symmetric, double negligible_share);

// Singular values, descending, and all right singular vectors as columns: those past the rank span the null space.
struct RightSingular {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
[[nodiscard]] RightSingular right_singular(const Eigen::MatrixXd& matrix);

// The inverse of a square matrix, by LU with partial pivoting; not finite where it is singular.
[[nodiscard]] Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& square);

// The x that minimises |matrix x - right|, by QR with column pivoting.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace glisson
