#pragma once
// What is left of the measurements, in blocks: rows are means over neighbours in time, in units of the noise, each
// direction by itself, with what is to be expected of them.

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "closedloop/experiment/observations.h"
#include "closedloop/experiment/whitening.h"

namespace glisson::closedloop {

// Rows of one direction, which has a process of its own; lengths are shared. In units of the noise as stated.
struct RestBlock {
  Eigen::VectorXd residual;
  Eigen::MatrixXd noise;                         // covariance
  Eigen::MatrixXd mesh;                          // ... of what the prediction itself may be off by; 0 x 0 for nothing
  std::vector<Eigen::MatrixXd> square_distance;  // a feature: between any two rows, the feature scaled to unit spread
  std::size_t time = 0;                          // which feature is time; as many as there are where none is
};

// What each row stands for: rows of the experiment that are averaged.
using Grouping = std::vector<std::vector<Eigen::Index>>;
// Neighbours in time, of one trial, direction and place; at most so many groups.
[[nodiscard]] Grouping grouped(const Observations& observations, std::size_t maximum);
// `kept`: the share of each error that the next sample of its series repeats.
[[nodiscard]] std::vector<RestBlock> blocks_of(const Observations& observations,
                                               const SystematicUncertainty& systematic, const Eigen::VectorXd& residual,
                                               const Grouping& groups, double kept);
// Root mean square of what is left, in units of what is to be expected of its rows.
[[nodiscard]] double size_of(const std::vector<RestBlock>& blocks);
[[nodiscard]] inline bool has_mesh_error(const std::vector<RestBlock>& blocks) {
  return blocks.front().mesh.size() > 0;
}

}  // namespace glisson::closedloop
