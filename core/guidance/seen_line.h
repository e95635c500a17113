#pragma once
// A line that a person marks on a picture, taken to space by what was seen of the organ's surface around it.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vision/calibration.h"

namespace glisson::guidance {

// Where the surface lies under a pixel (camera mm): a plane through the nearest points of the cloud, weighted by their
// nearness in the picture (local regression: Cleveland 1979, J Am Stat Assoc 74:829). Points beyond a step in depth do
// not count. Nothing where the nearest is farther than `within_px`: an instrument, or a gap.
[[nodiscard]] std::optional<Eigen::Vector3d> on_seen_surface(const vision::Camera& camera,
                                                             const std::vector<Eigen::Vector3d>& cloud_mm,
                                                             const Eigen::Vector2d& at_px, double within_px = 20);

// The same line with its places at most `spacing_mm` apart.
[[nodiscard]] std::vector<Eigen::Vector3d> filled_in(const std::vector<Eigen::Vector3d>& line_mm, double spacing_mm);

}  // namespace glisson::guidance
