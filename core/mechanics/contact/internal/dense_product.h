#pragma once
// A square matrix in single precision times a vector, as fast as the cache hands the matrix over: Eigen's product is
// compiled for the smallest vectors that any machine has.

#include <Eigen/Core>

namespace glisson::mechanics {

// Columns begin on vectors: a multiple of 16 rows, those after the matrix's own 0.
[[nodiscard]] Eigen::MatrixXf padded_rows(const Eigen::MatrixXf& matrix);

// y = M x of a matrix with padded rows; y has as many values as M has columns. Always the same bits, on one thread.
void multiply(const Eigen::MatrixXf& padded, const Eigen::VectorXf& x, Eigen::VectorXf& y);

}  // namespace glisson::mechanics
