#pragma once
// A x = b over frames by conjugate gradients (eqs. 4.7-4.10 of the dissertation), preconditioned either by the blocks
// of the diagonal or by a Cholesky factorisation that may be of an older A. Frames may describe one motion in two ways,
// so that A is semi-definite; conjugate gradients never enter what A does not see, and the factorisation is of A with
// its diagonal raised by a billionth. Inside of this room.

#include <Eigen/Core>
#include <optional>

#include "mechanics/cholesky_factor.h"
#include "mechanics/frame_matrix.h"

namespace glisson::mechanics {

class FramePreconditioner {
 public:
  // Of the diagonal's blocks.
  static FramePreconditioner of_diagonal(const FrameMatrix& matrix);
  // Factorised; by the diagonal's blocks where the factor would exceed the memory or a minute, or fails.
  static FramePreconditioner factorised(const FrameMatrix& matrix, std::uint64_t memory_limit_bytes);

  [[nodiscard]] Eigen::VectorXd apply(const Eigen::VectorXd& r) const;
  [[nodiscard]] bool is_factorised() const { return factor_.has_value(); }
  [[nodiscard]] std::uint64_t bytes() const { return factor_ ? factor_->bytes() : 0; }

 private:
  std::vector<FrameBlock> inverses_;
  std::optional<CholeskyFactor> factor_;
};

// The lower triangle with its diagonal raised by a billionth (of the largest entry where one is almost zero).
[[nodiscard]] Eigen::SparseMatrix<double> positive_definite(Eigen::SparseMatrix<double> lower);

struct FrameSolution {
  Eigen::VectorXd x;
  int iterations = 0;
  double relative_residual = 0;  // |b - A x| / |b|, of the residual itself and not of the recurrence
  bool converged = false;
};
[[nodiscard]] FrameSolution conjugate_gradients(const FrameMatrix& matrix, const FramePreconditioner& preconditioner,
                                                const Eigen::VectorXd& b, Eigen::VectorXd start, double tolerance,
                                                int max_iterations);

}  // namespace glisson::mechanics
