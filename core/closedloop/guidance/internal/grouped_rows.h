#pragma once
// Many rows of frames as few numbers, for a search that takes an adjoint solve a number. Rows that lie near each other,
// look the same way and were seen under the same loads, up to their size, become one number. It is their sum, each by
// how much of the load acted and how well it was seen (a matched filter of a change that is the same for all of them).

#include <Eigen/Core>
#include <vector>

#include "closedloop/experiment/observations.h"
#include "closedloop/guidance/internal/seen_row.h"
#include "closedloop/palpation/internal/ball_search.h"

namespace glisson::closedloop {

// `residual` (a number a row) is what is left; `amounts` are of each unit load (rows) in each frame (columns), divided
// by the stiffness factor; `turn` is the camera's against the organ. The numbers have a noise of 1.
[[nodiscard]] SeenNumbers grouped_rows(const std::vector<SeenRow>& rows, const Observations& observations,
                                       const Eigen::VectorXd& residual, const Eigen::MatrixXd& amounts,
                                       const Eigen::Matrix3d& turn, const PalpationSolver& solver);

}  // namespace glisson::closedloop
