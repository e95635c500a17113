#include "segmentation/resample.h"

#include <algorithm>
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

// Whether both grids' axes run alike, so that each axis can be gone along by itself.
bool alike_turned(const imaging::Grid& a, const imaging::Grid& b) {
  return (a.direction - b.direction).cwiseAbs().maxCoeff() < 1e-12;
}

// Between which two voxels of an axis a place lies, and how far along.
struct Stretch {
  int low, high;
  double along;
};

std::vector<Stretch> stretches(std::size_t axis, const imaging::Grid& from, const imaging::Grid& to) {
  const auto a = static_cast<Eigen::Index>(axis);
  const double start = from.index_of(to.origin_mm)[a], step = to.spacing_mm[a] / from.spacing_mm[a];
  std::vector<Stretch> found(static_cast<std::size_t>(to.size[axis]));
  for (std::size_t n = 0; n < found.size(); ++n) {
    const double at = std::clamp(start + step * static_cast<double>(n), 0.0, from.size[axis] - 1.0);
    const int low = static_cast<int>(at);
    found[n] = {low, std::min(low + 1, from.size[axis] - 1), at - low};
  }
  return found;
}

// What value_between() gives at each voxel.
imaging::Image<float> resampled_along_axes(const imaging::Image<float>& image, const imaging::Grid& grid) {
  const auto at_i = stretches(0, image.grid, grid), at_j = stretches(1, image.grid, grid),
             at_k = stretches(2, image.grid, grid);
  imaging::Image<float> resampled{grid, std::vector<float>(grid.voxels())};
  parallel_for(at_k.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> row(static_cast<std::size_t>(image.grid.size[0]));  // of the old grid, where the new one's lies
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t j = 0; j < at_j.size(); ++j) {
        std::fill(row.begin(), row.end(), 0.0);
        for (const int corner : {0, 1, 2, 3}) {
          const bool higher_j = (corner & 1) != 0, higher_k = (corner & 2) != 0;
          const double weight =
              (higher_j ? at_j[j].along : 1 - at_j[j].along) * (higher_k ? at_k[k].along : 1 - at_k[k].along);
          if (!(weight > 0)) continue;
          const float* const from = &image.values[image.grid.offset(0, higher_j ? at_j[j].high : at_j[j].low,
                                                                    higher_k ? at_k[k].high : at_k[k].low)];
          for (std::size_t i = 0; i < row.size(); ++i) row[i] += weight * static_cast<double>(from[i]);
        }
        float* const to = &resampled.values[grid.offset(0, static_cast<int>(j), static_cast<int>(k))];
        for (std::size_t i = 0; i < at_i.size(); ++i) {
          const auto& [low, high, along] = at_i[i];
          const double before = row[static_cast<std::size_t>(low)];
          to[i] = static_cast<float>(along > 0 ? (1 - along) * before + along * row[static_cast<std::size_t>(high)]
                                               : before);
        }
      }
    }
  });
  return resampled;
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
  if (alike_turned(image.grid, grid)) return resampled_along_axes(image, grid);
  imaging::Image<float> resampled{grid, std::vector<float>(grid.voxels())};
  for_each_voxel(image.grid, grid, [&](std::size_t voxel, const Eigen::Vector3d& source) {
    resampled.values[voxel] = static_cast<float>(value_between(image, source));
  });
  return resampled;
}

}  // namespace glisson::segmentation
