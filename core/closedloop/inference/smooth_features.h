#pragma once
// What a smooth function of what was done may depend on (smooth_rest.h): load, place and conditions, way (loading or
// unloading), time and the largest load so far.

#include <Eigen/Core>

#include "closedloop/experiment/observations.h"

namespace glisson::closedloop {

// Each that varies has a column, about its mean and in its own spread. Each observation has a row.
[[nodiscard]] Eigen::MatrixXd varying_features(const Observations& observations);

}  // namespace glisson::closedloop
