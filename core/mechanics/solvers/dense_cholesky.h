#pragma once
// Cholesky factorisation of a symmetric positive definite dense matrix of some hundred rows and more, kept for many
// right-hand sides: LAPACK, of which OpenBLAS takes a tenth of the time that Eigen does. On the thread that asks for
// it.

#include <Eigen/Core>
#include <optional>

namespace glisson::mechanics {

class DenseCholesky {
 public:
  // Of the lower triangle. Nothing where it is not positive definite.
  static std::optional<DenseCholesky> of(Eigen::MatrixXd lower);

  // One column a right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd right_hand_sides) const;
  // The factor L, below and on its diagonal.
  [[nodiscard]] const Eigen::MatrixXd& factor() const { return factor_; }

 private:
  explicit DenseCholesky(Eigen::MatrixXd factor) : factor_(std::move(factor)) {}
  Eigen::MatrixXd factor_;
};

}  // namespace glisson::mechanics
