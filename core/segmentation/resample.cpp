#include "segmentation/resample.h"

#include <cmath>

#include "base/parallel.h"

namespace glisson::segmentation {

namespace {

// Calls at(voxel of `to`, where its centre lies in `from` as an index) for each voxel of `to`, several at once.
template <typename At>
void for_each_voxel(const imaging::Grid& from, const imaging::Grid& to, const At& at) {
  // The map from an index of the new grid to one of the old is affine.
  const Eigen::Vector3d start = from.index_of(to.position_mm(0, 0, 0));
  Eigen::Matrix3d step;
  for (int axis = 0; axis < 3; ++axis) {
    step.col(axis) = from.index_of(to.position_mm(Eigen::Vector3d::Unit(axis))) - start;
  }
  parallel_for(static_cast<std::size_t>(to.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < to.size[1]; ++j) {
        for (int i = 0; i < to.size[0]; ++i) {
          at(to.offset(i, j, k), Eigen::Vector3d(start + step * Eigen::Vector3d(i, j, k)));
        }
      }
    }
  });
}

}  // namespace

imaging::Mask resample(const imaging::Mask& mask, const imaging::Grid& grid) {
  if (imaging::same_grid(mask.grid, grid)) return mask;
  imaging::Mask resampled{grid, std::vector<std::uint8_t>(grid.voxels())};
  for_each_voxel(mask.grid, grid, [&](std::size_t voxel, const Eigen::Vector3d& source) {
    const Eigen::Vector3d nearest = (source.array() + 0.5).floor();
    // Compared as doubles, so that a far-off position cannot overflow an index.
    if ((nearest.array() < 0).any() || nearest.x() >= mask.grid.size[0] || nearest.y() >= mask.grid.size[1] ||
        nearest.z() >= mask.grid.size[2]) {
      return;
    }
    resampled.values[voxel] =
        mask.at(static_cast<int>(nearest.x()), static_cast<int>(nearest.y()), static_cast<int>(nearest.z()));
  });
  return resampled;
}

double value_between(const imaging::Image<float>& image, const Eigen::Vector3d& index) {
  const Eigen::Vector3d last(image.grid.size[0] - 1, image.grid.size[1] - 1, image.grid.size[2] - 1);
  const Eigen::Vector3d within = index.cwiseMax(0).cwiseMin(last);
  const Eigen::Vector3i low = within.array().floor().cast<int>(),
                        high = (low.array() + 1).min(last.cast<int>().array());
  const Eigen::Vector3d t = within - low.cast<double>();
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const bool i = (corner & 1) != 0, j = (corner & 2) != 0, k = (corner & 4) != 0;
    const double weight = (i ? t.x() : 1 - t.x()) * (j ? t.y() : 1 - t.y()) * (k ? t.z() : 1 - t.z());
    if (weight > 0) {
      sum += weight *
             static_cast<double>(image.at(i ? high.x() : low.x(), j ? high.y() : low.y(), k ? high.z() : low.z()));
    }
  }
  return sum;
}

imaging::Image<float> resample(const imaging::Image<float>& image, const imaging::Grid& grid) {
  if (imaging::same_grid(image.grid, grid)) return image;
  imaging::Image<float> resampled{grid, std::vector<float>(grid.voxels())};
  for_each_voxel(image.grid, grid, [&](std::size_t voxel, const Eigen::Vector3d& source) {
    resampled.values[voxel] = static_cast<float>(value_between(image, source));
  });
  return resampled;
}

}  // namespace glisson::segmentation
