#pragma once
// The weights of "something else" in a posterior: in place of all causes, or beside the leading ones.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/inference/internal/weighed.h"

namespace glisson::closedloop {

// Natural logarithms, priors included; the last is beside the leading ones, where these are any. `declared`: what the
// declared model predicts; `of_nothing`: its evidence.
[[nodiscard]] Result<std::vector<double>> weights_of_something_else(const Weighing& weighing,
                                                                    const Eigen::VectorXd& declared,
                                                                    const Weighed& leading, double of_nothing,
                                                                    const PosteriorOptions& options,
                                                                    const Progress& progress);

// Root mean square by which what is left exceeds the noise, in noises.
[[nodiscard]] double excess(const Observations& observations, const Eigen::VectorXd& predicted);
[[nodiscard]] double root_mean_square(const Eigen::VectorXd& values);

}  // namespace glisson::closedloop
