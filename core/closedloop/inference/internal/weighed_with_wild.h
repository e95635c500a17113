#pragma once
// The evidence of sets of effects where some values are wild (wild_values.h).

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "closedloop/experiment/whitening.h"
#include "closedloop/inference/internal/weighed.h"

namespace glisson::closedloop {

// One guess of which values are wild, with what it makes of every set.
struct WithWildValues {
  std::unique_ptr<Whitening> whitening;
  Eigen::VectorXd worth;  // of each row (Weighing::worth)
  // In the order of those without wild values; of no evidence where it was not asked for.
  std::vector<Weighed> all;

  [[nodiscard]] Weighing weighing(const Weighing& without) const {
    return {without.model, without.systematic, *whitening, without.correlation, worth};
  }
};

// By what nothing and by what the likeliest of `all` leave. The guess that gives a set the higher evidence is the
// better one for it: both are lower bounds. None where instruments did not measure one value after the other, where
// predicting takes long, or where the prediction's own error hides what is small.
[[nodiscard]] std::vector<WithWildValues> weighed_with_wild_values(const Weighing& weighing,
                                                                   const std::vector<Weighed>& all,
                                                                   const PosteriorOptions& options,
                                                                   const Progress& progress);

}  // namespace glisson::closedloop
