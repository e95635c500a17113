#pragma once
// K u = f where some of u is given: factorised once, solved for many f. Iterative refinement brings the residual down
// to what was asked, or says that it could not.

#include <cstdint>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/solvers/cholesky_factor.h"
#include "mechanics/solvers/digits.h"

namespace glisson::mechanics {

// Refinement goes on while it gains and the residual is above `target`; what it reaches counts as converged when it is
// within `tolerance`. The two differ because rounding sets a floor of about 1e-16 |K| |u| / |f|. A slender body, or one
// near incompressibility, meets that above the target.
struct Refinement {
  double target = 1e-10;
  double tolerance = 1e-6;
  int max_refinements = 8;
};

struct ConstrainedSolution {
  Eigen::VectorXd u;             // all unknowns, the given ones included
  Eigen::VectorXd reaction;      // K u - f where u is given, zero elsewhere
  double relative_residual = 0;  // |K u - f| / |f - K u_given| over the free unknowns; 0 where nothing loads them
  int iterations = 0;
  bool converged = false;
};

class ConstrainedSystem {
 public:
  // `lower` is the lower triangle of K, with all unknowns; `given` has 1 where u is given; `known` is the order of a
  // system that may be alike; `mutual` are unknowns whose answers to each other are wanted. Failures: CholeskyFactor's.
  static Result<ConstrainedSystem> create(Eigen::SparseMatrix<double> lower, std::vector<std::uint8_t> given,
                                          std::uint64_t memory_limit_bytes, const Progress& progress = {},
                                          std::shared_ptr<const EliminationOrder> known = nullptr,
                                          std::vector<int> mutual = {});
  [[nodiscard]] std::shared_ptr<const EliminationOrder> order() const { return factor_ ? factor_->order() : nullptr; }

  // One column of f a case. `given_u` has the same shape and is read where u is given; empty means zero.
  [[nodiscard]] std::vector<ConstrainedSolution> solve(const Eigen::MatrixXd& f, const Eigen::MatrixXd& given_u,
                                                       const Refinement& refinement) const;

  // Halves the factor's memory: solutions are the same to the refinement's target, by more passes of half the cost.
  void keep_factor_in_single_precision();

  // By the factor alone, nothing given. `relative_residual` is of a sum of the columns with signs that look random. It
  // costs one product, not one a column. No column's error hides in it but by chance. A factor in single precision is
  // refined for all digits; for those that are seen only where its answers are off by more than 1e-5.
  struct Response {
    Eigen::MatrixXd u;
    double relative_residual = 0;
    bool is_seen_right = false;  // unrefined, to 1e-5
  };
  [[nodiscard]] Response respond(const Eigen::MatrixXd& f, Digits digits = Digits::all) const;

  // How each of `mutual` moves (rows) by a unit force on each (columns), nothing given; zeros where u is.
  [[nodiscard]] Eigen::MatrixXd mutual_compliance() const;

  [[nodiscard]] const Eigen::SparseMatrix<double>& lower() const { return lower_; }
  [[nodiscard]] std::size_t free_unknowns() const { return free_.size(); }
  [[nodiscard]] std::uint64_t matrix_bytes() const;
  // No factor where nothing is free to move.
  [[nodiscard]] const std::optional<CholeskyFactor>& factor() const { return factor_; }

 private:
  Eigen::SparseMatrix<double> lower_;
  std::vector<int> free_;  // the unknowns that are not given, ascending
  std::vector<int> mutual_;
  bool answers_as_seen_ = false;  // in single precision, unrefined
  std::optional<CholeskyFactor> factor_;
};

}  // namespace glisson::mechanics
