#pragma once
// A convex organ and straight vessels, whose territories are known by distances alone.

#include "imaging/image.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

// A ball of 40 mm on voxels that are no cubes.
inline imaging::Mask ball() {
  imaging::Grid grid;
  grid.size = {84, 84, 56};
  grid.spacing_mm = {1, 1, 1.5};
  grid.origin_mm = {-41, -41, -41};
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (grid.position_mm(i, j, k).norm() < 40) mask.at(i, j, k) = 1;
      }
    }
  }
  return mask;
}

inline TreeBranch straight(System system, int parent, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                           double radius_mm) {
  TreeBranch branch;
  branch.system = system;
  branch.parent = parent;
  for (int i = 0; i <= 30; ++i) branch.points.push_back({from + i / 30.0 * (to - from), radius_mm});
  branch.radius_mm = radius_mm;
  branch.length_mm = (to - from).norm();
  return branch;
}

}  // namespace glisson::vasculature
