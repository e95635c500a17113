#include "segmentation/resample.h"

#include <cmath>

#include "base/parallel.h"

namespace glisson::segmentation {

imaging::Mask resample(const imaging::Mask& mask, const imaging::Grid& grid) {
  if (imaging::same_grid(mask.grid, grid)) return mask;

  imaging::Mask resampled{grid, std::vector<std::uint8_t>(grid.voxels())};
  // The map from an index of the new grid to one of the old is affine.
  const Eigen::Vector3d start = mask.grid.index_of(grid.position_mm(0, 0, 0));
  Eigen::Matrix3d step;
  for (int axis = 0; axis < 3; ++axis) {
    step.col(axis) = mask.grid.index_of(grid.position_mm(Eigen::Vector3d::Unit(axis))) - start;
  }
  parallel_for(static_cast<std::size_t>(grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          const Eigen::Vector3d source = start + step * Eigen::Vector3d(i, j, k);
          const Eigen::Vector3d nearest = (source.array() + 0.5).floor();
          // Compared as doubles, so that a far-off position cannot overflow an index.
          if ((nearest.array() < 0).any() || nearest.x() >= mask.grid.size[0] || nearest.y() >= mask.grid.size[1] ||
              nearest.z() >= mask.grid.size[2]) {
            continue;
          }
          resampled.at(i, j, k) =
              mask.at(static_cast<int>(nearest.x()), static_cast<int>(nearest.y()), static_cast<int>(nearest.z()));
        }
      }
    }
  });
  return resampled;
}

}  // namespace glisson::segmentation
