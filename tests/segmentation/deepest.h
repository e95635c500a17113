#pragma once
// Where a person would click into a structure: its voxel that is farthest from what is outside.

#include <algorithm>
#include <Eigen/Core>
#include <vector>

#include "imaging/filters.h"

namespace glisson::segmentation {

inline Eigen::Vector3d deepest_mm(const imaging::Mask& mask) {
  const std::vector<float> depths = imaging::squared_depths_mm2(mask);
  const auto at = static_cast<std::size_t>(std::max_element(depths.begin(), depths.end()) - depths.begin());
  const auto nx = static_cast<std::size_t>(mask.grid.size[0]), ny = static_cast<std::size_t>(mask.grid.size[1]);
  return mask.grid.position_mm(static_cast<int>(at % nx), static_cast<int>(at / nx % ny),
                               static_cast<int>(at / (nx * ny)));
}

}  // namespace glisson::segmentation
