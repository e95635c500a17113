#pragma once
// Matching sampled points of one surface to sampled points of another by their geodesic distances, as a Markov random
// field. Source: Chen and Koltun 2015; sections 3.2 and 3.2.3 of the dissertation. A node is a point of the source, a
// label is a point of the target, and every pair of nodes is joined. To give node i the label k and node j the label l
// costs
//
//   E(x, y) = q exp(-min(x, y) / sigma) min(|x - y|, tau),   x = source_mm(i, j),  y = target_mm(k, l)     (eq. 3.1)
//           = max(q exp(-x / sigma), q exp(-y / sigma)) min(|x - y|, tau)                                  (eq. 3.2)
//
// so that near points must keep their distance, far ones may stretch, and one bad pair costs no more than q tau.

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::registration {

// The field as the few numbers that it is made of.
struct MatchingProblem {
  Eigen::MatrixXd source_mm;  // nodes x nodes: geodesic distances; symmetric, zero diagonal
  Eigen::MatrixXd target_mm;  // labels x labels, the same
  Eigen::MatrixXd seed;  // nodes x labels: what each label costs by itself (U of algorithm 1), or empty for nothing
  double sigma_mm = 0;   // how soon a pair of far points counts less
  double tau_mm = 0;     // the largest difference that still counts more
  double q = 1;          // energy a mm

  [[nodiscard]] int nodes() const { return static_cast<int>(source_mm.rows()); }
  [[nodiscard]] int labels() const { return static_cast<int>(target_mm.rows()); }
  [[nodiscard]] std::size_t pairs_of_nodes() const;
};

// Fails with "matching-distances" where a matrix is not square, symmetric, finite and nonnegative with a zero diagonal.
// Fails with "matching-too-few-points" below two nodes or labels, and with "matching-too-many-points" above 4096. Fails
// with "matching-seed" for a seed of another shape or not finite, and with "matching-constants" for constants that are
// not positive.
Result<void> check(const MatchingProblem& problem);

// A label for each node.
using Labelling = std::vector<int>;

// Energies of labellings by eq. 3.2 in double precision, in units of q mm. Keeps the exponentials.
class MatchingEnergy {
 public:
  explicit MatchingEnergy(const MatchingProblem& problem);

  // What it costs that nodes i != j take labels k and l.
  [[nodiscard]] double of_pair(int i, int j, int k, int l) const;
  [[nodiscard]] double operator()(const Labelling& labelling) const;

 private:
  const MatchingProblem& problem_;
  Eigen::MatrixXd source_weight_;  // a = q exp(-x / sigma)
  Eigen::MatrixXd target_weight_;  // b = q exp(-y / sigma)
};

// The field written out, as general solvers want it. Every pair of nodes i < j has one matrix of labels x labels, with
// the label of i as its row. Takes 8 nodes^2 labels^2 / 2 bytes.
struct StoredMrf {
  int nodes = 0;
  int labels = 0;
  std::vector<double> unary;     // unary[node * labels + label]
  std::vector<double> pairwise;  // see pair()

  [[nodiscard]] const double* pair(int i, int j) const;  // i < j; [k * labels + l]
  [[nodiscard]] double energy(const Labelling& labelling) const;
};

// Evaluates eq. 3.1, exponential and all, for every pair of nodes and of labels: the step "GH" of the dissertation's
// baseline. Refuses a bad problem as check() does, and one that needs more than `limit_bytes` ("mrf-too-large").
// Fails with "cancelled".
Result<StoredMrf> store(const MatchingProblem& problem, std::uint64_t limit_bytes = std::uint64_t{8} << 30,
                        const Progress& progress = {});

// ---- What a solver answers ----

enum class Stopping {
  fixed_passes,  // exactly `passes`, to compare speeds
  dynamic        // when the bound is met or the energy has stopped falling, at most `passes`
};

struct SolverOptions {
  int passes = 20;  // 1 or more; the dissertation's fixed number (section 3.3.5); a pass goes once forth and once back
  Stopping stopping = Stopping::dynamic;
  int patience =
      3;  // passes without a lower energy before it is said to have stopped falling: TRW-S often pauses for two
  double relative_gap = 1e-6;  // the bound is met when the energy lies this little above it
};

enum class StopReason { not_run, bound_met, energy_stopped_falling, all_passes_done, cancelled };

struct SolverPass {
  double energy = 0;       // of this pass's own labelling
  double lower_bound = 0;  // no labelling costs less
};

struct MatchingSolution {
  Labelling labels;  // the best labelling of all passes, which need not be the last
  double energy = 0;
  double lower_bound = 0;
  std::vector<SolverPass> passes;
  StopReason stopped = StopReason::not_run;
  double solve_ms = 0;
};

// Whether the passes so far are enough, and why.
[[nodiscard]] StopReason reason_to_stop(const std::vector<SolverPass>& passes, const SolverOptions& options);

}  // namespace glisson::registration
