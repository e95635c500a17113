#include "segmentation/internal/seeds.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/sentence.h"

namespace glisson::segmentation {

using Eigen::Vector3d;
using imaging::Grid;

Result<void> check_image(const imaging::Volume& image) {
  const std::array<int, 3>& size = image.grid.size;
  if (*std::min_element(size.begin(), size.end()) >= 3 && image.values.size() == image.grid.voxels()) return {};
  return failure("grow-bad-image", GLISSON_TEXT("An image of {0} x {1} x {2} voxels is too thin to grow in."),
                 {std::to_string(size[0]), std::to_string(size[1]), std::to_string(size[2])});
}

Result<void> check_seeds(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm) {
  if (auto checked = check_image(image); !checked) return checked;
  if (seeds_mm.empty()) {
    return failure(Error{"grow-no-seeds",
                         GLISSON_TEXT("There is no seed to grow from."),
                         {},
                         GLISSON_TEXT("Give at least one point in the middle of the liver."),
                         {}});
  }
  const Vector3d last(image.grid.size[0] - 1, image.grid.size[1] - 1, image.grid.size[2] - 1);
  for (std::size_t n = 0; n < seeds_mm.size(); ++n) {
    const Vector3d index = image.grid.index_of(seeds_mm[n]);
    const Vector3d inside = index.cwiseMax(Vector3d::Constant(-0.5)).cwiseMin(last + Vector3d::Constant(0.5));
    const double outside_mm = (index - inside).cwiseProduct(image.grid.spacing_mm).norm();
    if (outside_mm <= 1e-6) continue;  // false for NaN
    return failure(Error{"grow-seed-outside",
                         GLISSON_TEXT("Seed {0} at ({1}) mm lies {2} mm outside the image."),
                         {std::to_string(n + 1),
                          fmt::format("{:.1f}, {:.1f}, {:.1f}", seeds_mm[n].x(), seeds_mm[n].y(), seeds_mm[n].z()),
                          fmt::format("{:.1f}", outside_mm)},
                         GLISSON_TEXT("Seeds are DICOM patient coordinates (LPS) in mm, not voxel indices."),
                         {}});
  }
  return {};
}

std::vector<std::size_t> voxels_around(const Vector3d& center_mm, double radius_mm, const Grid& grid) {
  std::vector<std::size_t> voxels;
  const Vector3d center = grid.index_of(center_mm);
  std::array<int, 3> first{}, last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double reach = radius_mm / grid.spacing_mm[a];
    first[axis] = static_cast<int>(std::clamp(std::ceil(center[a] - reach), 0.0, grid.size[axis] - 1.0));
    last[axis] = static_cast<int>(std::clamp(std::floor(center[a] + reach), 0.0, grid.size[axis] - 1.0));
  }
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int i = first[0]; i <= last[0]; ++i) {
        if ((grid.position_mm(i, j, k) - center_mm).norm() <= radius_mm) voxels.push_back(grid.offset(i, j, k));
      }
    }
  }
  return voxels;
}

Eigen::Vector3i index_of(std::size_t voxel, const Grid& grid) {
  const auto row = static_cast<std::size_t>(grid.size[0]), layer = row * static_cast<std::size_t>(grid.size[1]);
  return {static_cast<int>(voxel % row), static_cast<int>(voxel % layer / row), static_cast<int>(voxel / layer)};
}

std::optional<std::size_t> nearest_voxel(const Vector3d& place_mm, double radius_mm, const imaging::Mask& mask) {
  std::optional<std::size_t> nearest;
  double nearest_mm = INFINITY;
  for (const std::size_t voxel : voxels_around(place_mm, radius_mm, mask.grid)) {
    if (mask.values[voxel] == 0) continue;
    const Eigen::Vector3i index = index_of(voxel, mask.grid);
    const double away_mm = (mask.grid.position_mm(index.x(), index.y(), index.z()) - place_mm).norm();
    if (away_mm < nearest_mm) nearest_mm = away_mm, nearest = voxel;
  }
  return nearest;
}

imaging::Mask joined_to(const std::vector<std::size_t>& voxels, const imaging::Mask& mask,
                        imaging::Neighbours neighbours) {
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(mask, neighbours);
  std::vector<bool> kept(connected.sizes.size(), false);
  for (const std::size_t voxel : voxels) kept[connected.piece[voxel]] = true;
  kept[0] = false;
  imaging::Mask joined{mask.grid, std::vector<std::uint8_t>(mask.values.size(), 0)};
  for (std::size_t voxel = 0; voxel < joined.values.size(); ++voxel) {
    joined.values[voxel] = kept[connected.piece[voxel]] ? 1 : 0;
  }
  return joined;
}

}  // namespace glisson::segmentation
