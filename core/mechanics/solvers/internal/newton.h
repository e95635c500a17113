#pragma once
// Newton's method on an energy, with a line search (Nocedal and Wright, Numerical Optimization, 3.1 and 3.4). It takes
// the exact tangent where that is positive definite, and its positive part where it is not.

#include <cstdint>
#include <Eigen/SparseCore>
#include <limits>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/solvers/objective.h"

namespace glisson::mechanics {

struct NewtonResult {
  Eigen::VectorXd u_mm;
  double relative_residual = 0;  // of `scale_mN`, over what is not fixed
  int steps = 0;
  bool converged = false;
  bool hopeless = false;  // the first direction was longer than allowed
};

// From `start_mm`, which keeps its values where `fixed` is 1. Where the scale is zero nothing loads what is free, and
// the start is the answer. Failures: "too-large", "factorisation-failed", "cancelled".
struct MinimiseOptions {
  double relative_tolerance = 1e-6;
  int max_steps = 40;
  std::uint64_t memory_limit_bytes = 0;
  double longest_mm = std::numeric_limits<double>::infinity();  // of the first direction, at any node
};
Result<NewtonResult> minimise(const Objective& objective, const std::vector<std::uint8_t>& fixed, double scale_mN,
                              const Eigen::VectorXd& start_mm, const MinimiseOptions& options,
                              const Progress& progress);

// The values with zeros where something is fixed.
[[nodiscard]] Eigen::VectorXd free_values(const std::vector<std::uint8_t>& fixed, Eigen::VectorXd values);

}  // namespace glisson::mechanics
