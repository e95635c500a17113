#pragma once
// Sets of effects as a posterior weighs them, and what it says of them by the noise alone.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "closedloop/inference/posterior.h"

namespace glisson::closedloop {

using Kinds = std::vector<std::string>;

// A set of effects with its evidence and its share of what was believed; natural logarithms.
struct Weighed {
  LocalFit fit;
  Kinds kinds;
  LogEvidence log;
  double log_prior = 0;

  [[nodiscard]] double weight() const { return log.evidence + log_prior; }
};

// No effects: always among those weighed.
[[nodiscard]] const Weighed& nothing_of(const std::vector<Weighed>& all);
[[nodiscard]] std::size_t likeliest_of(const std::vector<Weighed>& all);

// Moves those that are not far below the best to the maximum of their posterior, for models that predict quickly.
void refine(const Weighing& weighing, std::vector<Weighed>& all, const PosteriorOptions& options,
            const Progress& progress);

}  // namespace glisson::closedloop
