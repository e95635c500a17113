#include "mechanics/solvers/dense_cholesky.h"

#include "base/result.h"

// LAPACK's Cholesky factorisation, in place, and what it solves.
extern "C" void dpotrf_(const char* triangle, const int* size, double* a, const int* leading, int* info);
extern "C" void dpotrs_(const char* triangle, const int* size, const int* columns, const double* a, const int* leading,
                        double* b, const int* leading_of_b, int* info);

namespace glisson::mechanics {

std::optional<DenseCholesky> DenseCholesky::of(Eigen::MatrixXd lower) {
  GLISSON_ASSERT(lower.rows() == lower.cols() && lower.rows() < (1 << 30));
  const int size = static_cast<int>(lower.rows());
  int info = 0;
  if (size > 0) dpotrf_("L", &size, lower.data(), &size, &info);
  if (info != 0) return std::nullopt;
  return DenseCholesky(std::move(lower));
}

Eigen::MatrixXd DenseCholesky::solve(Eigen::MatrixXd right_hand_sides) const {
  GLISSON_ASSERT(right_hand_sides.rows() == factor_.rows() && right_hand_sides.cols() < (1 << 30));
  const int size = static_cast<int>(factor_.rows()), columns = static_cast<int>(right_hand_sides.cols());
  int info = 0;
  if (size > 0 && columns > 0) {
    dpotrs_("L", &size, &columns, factor_.data(), &size, right_hand_sides.data(), &size, &info);
  }
  GLISSON_ASSERT(info == 0);
  return right_hand_sides;
}

}  // namespace glisson::mechanics
