#pragma once
// What a Cholesky factor would cost, known from the pattern alone.

#include <Eigen/SparseCore>

namespace glisson::mechanics {

struct FillIn {
  double entries = 0;     // of the factor
  double operations = 0;  // that make it
};

// As CholeskyFactor orders it; the values are not read.
[[nodiscard]] FillIn fill_in_of(const Eigen::SparseMatrix<double>& lower);

}  // namespace glisson::mechanics
