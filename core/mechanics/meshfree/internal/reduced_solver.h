#pragma once
// A x = b over handles by conjugate gradients (eqs. 4.7-4.10 of the dissertation). Where A is assembled, its Cholesky
// factor, which may be of an older A, preconditions them. Where it is not, two levels do, added up:
//
//   r -> D^-1 r + R (R^T A R)^-1 R^T r
//
// D is the 12x12 blocks of the diagonal. R leads the handles by some hundred coarse ones on a lattice, which hold the
// smooth motions. Handles that follow affine fields blend to a blend of these. So R^T A R is exactly the engine's own
// matrix over the leaders, and small enough to be factorised (any text on domain decomposition, e.g. Toselli and
// Widlund 2005, 2.5 and 3). Handles may describe one motion in two ways, so that A is semi-definite. Conjugate
// gradients never enter what A does not see. What is factorised is A with its diagonal raised by as little as makes it
// definite. Each digit less saves iterations: with 500 handles, to 1e-6, there are 193 with 1e-9 and 3 with 1e-13.

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "mechanics/meshfree/internal/reduced_operator.h"
#include "mechanics/solvers/cholesky_factor.h"

namespace glisson::mechanics {

class ReducedPreconditioner {
 public:
  static ReducedPreconditioner of(const ReducedOperator& matrix, std::uint64_t memory_limit_bytes);

  [[nodiscard]] Eigen::VectorXd apply(const Eigen::VectorXd& r) const;
  // The factor of A itself; nullptr where it is not that.
  [[nodiscard]] const CholeskyFactor* whole_factor() const { return inverses_.empty() ? &*factor_ : nullptr; }
  // After how many iterations another would pay.
  [[nodiscard]] int patience() const { return lead_ ? 400 : 30; }
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  std::vector<Eigen::Matrix<float, handle_size, handle_size>> inverses_;  // of the diagonal's blocks
  std::optional<CholeskyFactor> factor_;                                  // of A, or of the leaders' matrix
  std::optional<HandleLead> lead_;
  std::shared_ptr<const AffineBasis> basis_;  // of the handles that are led
};

// The lower triangle with its diagonal raised by that share (of the largest entry where one is almost zero).
[[nodiscard]] Eigen::SparseMatrix<double> positive_definite(Eigen::SparseMatrix<double> lower, double raise = 1e-9);

struct ReducedSolution {
  Eigen::VectorXd x;
  int iterations = 0;
  double relative_residual = 0;  // |b - A x| / |b|, of the residual itself and not of the recurrence
  bool converged = false;
};
[[nodiscard]] ReducedSolution conjugate_gradients(const ReducedOperator& matrix,
                                                  const ReducedPreconditioner& preconditioner, const Eigen::VectorXd& b,
                                                  Eigen::VectorXd start, double tolerance, int max_iterations);

// Many right-hand sides at once, one a column: by A's own factor, refined until each is within the tolerance, or by
// conjugate gradients one after the other where that does not lead there. A must be assembled and factorised.
struct ReducedSolutions {
  Eigen::MatrixXd x;
  double relative_residual = 0;  // the worst of the columns
};
[[nodiscard]] ReducedSolutions solve_together(const ReducedOperator& matrix,
                                              const ReducedPreconditioner& preconditioner, const Eigen::MatrixXd& b,
                                              double tolerance, int max_iterations);

}  // namespace glisson::mechanics
