#pragma once
// The baseline of every explanation: whatever the cause may be, the specimen answers smoothly to what is done to it.
// What the declared model leaves is fitted by a Gaussian process, and its evidence says how well that alone accounts
// for it. It depends on load, way (loading or unloading), time, the largest load so far, place and conditions. Its
// amplitudes and lengths are those of the largest evidence. Named causes must be better evidence than that; else the
// data show that something acts, not what.
//
// Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), 5.4.1 (evidence, one length a feature);
// Schwarz 1978 for what the freedom costs.

#include <Eigen/Core>

#include "base/progress.h"
#include "closedloop/experiment/observations.h"

namespace glisson::closedloop {

// How much better evidence an explanation is than the baseline, as a difference of BIC: positive where the explanation
// is the better one. `declared` and `explained` are what the declared model and the explanation leave (measured -
// predicted), `parameters` how many numbers the explanation took. Both are weighed over the same rows, evenly from all.
// These are at most 400, and no more than are independent of each other (rows / correlation). Noise is at least as
// large as stated, and as large as the explanation leaves it. Nothing fails: where the search is cancelled, its best so
// far.
[[nodiscard]] double evidence_over_smooth(const Observations& observations, const Eigen::VectorXd& declared,
                                          const Eigen::VectorXd& explained, Eigen::Index parameters, double correlation,
                                          const Progress& progress = {});

// What a smooth function may depend on: load, place and conditions, way, time and the largest load so far. Each that
// varies has a column, about its mean and in its own spread. Each observation has a row.
[[nodiscard]] Eigen::MatrixXd varying_features(const Observations& observations);

}  // namespace glisson::closedloop
