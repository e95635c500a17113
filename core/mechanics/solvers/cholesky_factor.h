#pragma once
// Cholesky factorisation of a symmetric positive definite sparse matrix, kept for many right-hand sides: CHOLMOD,
// supernodal, nested dissection by METIS. OpenBLAS does the arithmetic: with the reference BLAS it is ten times slower.
//
// Some unknowns may be eliminated after all others. Their part of the inverse then comes of the factor's last corner
// alone, with no solve: L = [A 0; B C] gives (C C^T)^-1, the inverse of Schur's complement (e.g. Golub and Van Loan,
// Matrix Computations, 3.2.11 and 4.2).

#include <cstdint>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::mechanics {

// The order of elimination and the fill-in, which a matrix's pattern decides alone: found once, it serves every matrix
// of that pattern.
class EliminationOrder;

class CholeskyFactor {
 public:
  // `lower` holds the lower triangle. Failures: "too-large" (the factor would take more than the limit, known before
  // it is asked for), "factorisation-failed" (not positive definite, or out of memory), "cancelled". A `known` order is
  // taken where it belongs to this pattern; the factor is the same to the bit with it and without. `last` are unknowns
  // to be eliminated last, each once; with them an order is neither read nor given.
  static Result<CholeskyFactor> create(const Eigen::SparseMatrix<double>& lower, std::uint64_t memory_limit_bytes,
                                       const Progress& progress = {},
                                       std::shared_ptr<const EliminationOrder> known = nullptr,
                                       const std::vector<int>& last = {});
  [[nodiscard]] std::shared_ptr<const EliminationOrder> order() const;

  // Rounds the numbers, which halves memory and time; solutions then carry some four digits, to be refined by their
  // residuals. What inverse_of_last() would give is lost: only for factors without `last` unknowns.
  void keep_in_single_precision();
  [[nodiscard]] bool in_single_precision() const;

  // One column a right-hand side. Safe from several threads; in full precision one at a time.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

  // The rows and columns of the inverse that belong to `last`, in its order.
  [[nodiscard]] Eigen::MatrixXd inverse_of_last() const;

  // A cheap estimate of the condition from the factor's diagonal, 1 at best. Below about 1e-14 the solution has no
  // correct digit left.
  [[nodiscard]] double reciprocal_condition() const;
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct State;
  explicit CholeskyFactor(std::shared_ptr<State> state) : state_(std::move(state)) {}
  std::shared_ptr<State> state_;
};

}  // namespace glisson::mechanics
