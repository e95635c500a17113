#pragma once
// The voxel whose centre is nearest to a place.

#include <cmath>
#include <cstddef>
#include <optional>

#include "imaging/image.h"

namespace glisson::vasculature {

// Its offset in the grid's values; nothing beside the grid.
inline std::optional<std::size_t> nearest_voxel(const imaging::Grid& grid, const Eigen::Vector3d& position_mm) {
  const Eigen::Vector3d at = grid.index_of(position_mm);
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y())),
            k = static_cast<int>(std::lround(at.z()));
  if (!grid.contains(i, j, k)) return std::nullopt;
  return grid.offset(i, j, k);
}

}  // namespace glisson::vasculature
