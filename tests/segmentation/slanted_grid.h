#pragma once
// A grid that no axis of the patient runs along, with three spacings.

#include <cstdint>
#include <Eigen/Geometry>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

inline imaging::Grid slanted_grid() {
  imaging::Grid grid;
  grid.size = {30, 26, 18};
  grid.spacing_mm = {1.0, 1.2, 2.5};
  grid.direction = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 1, -1).normalized()).toRotationMatrix();
  grid.origin_mm = {10, -20, 30};
  return grid;
}

inline imaging::Mask empty_mask(const imaging::Grid& grid = slanted_grid()) {
  return {grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
}

}  // namespace glisson::segmentation
