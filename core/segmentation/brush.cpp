#include "segmentation/brush.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/result.h"
#include "base/upper_median.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Grid;

IndexBox box_around(const Grid& grid, const Vector3d& low_index, const Vector3d& high_index);
double squared_distance_mm2(const Vector3d& place_mm, const Vector3d& from_mm, const Vector3d& along_mm);

}  // namespace

IndexBox IndexBox::joined(const IndexBox& other) const {
  if (empty()) return other;
  if (other.empty()) return *this;
  IndexBox both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.first[axis] = std::min(first[axis], other.first[axis]);
    both.last[axis] = std::max(last[axis], other.last[axis]);
  }
  return both;
}

IndexBox draw(imaging::Mask& mask, const Dab& dab, Paint paint, const std::optional<Only>& only) {
  GLISSON_ASSERT(!only || imaging::same_grid(only->image.grid, mask.grid));
  if (!(dab.radius_mm > 0) || !dab.from_mm.allFinite() || !dab.to_mm.allFinite()) return {};
  const Grid& grid = mask.grid;
  Vector3d from_mm = dab.from_mm, to_mm = dab.to_mm;
  const Vector3d normal = dab.plane_normal.value_or(Vector3d::Zero());
  const double thickness_mm = dab.plane_normal ? half_extent_mm(grid, normal) : 0;
  const Vector3d reach =
      (Vector3d::Constant(dab.radius_mm + thickness_mm).cwiseQuotient(grid.spacing_mm).array() + 1e-9).matrix();
  Vector3d a = grid.index_of(from_mm), b = grid.index_of(to_mm);
  if (dab.layer_axis) {
    // Within the layer both ends count as lying in the middle of it.
    a[*dab.layer_axis] = b[*dab.layer_axis] = std::round(b[*dab.layer_axis]);
    from_mm = grid.position_mm(a);
    to_mm = grid.position_mm(b);
  }
  Vector3d low = a.cwiseMin(b) - reach, high = a.cwiseMax(b) + reach;
  if (dab.layer_axis) low[*dab.layer_axis] = high[*dab.layer_axis] = b[*dab.layer_axis];
  const IndexBox box = box_around(grid, low, high);
  const std::uint8_t value = paint == Paint::add ? 1 : 0;
  for (int k = box.first[2]; k <= box.last[2]; ++k) {
    for (int j = box.first[1]; j <= box.last[1]; ++j) {
      for (int i = box.first[0]; i <= box.last[0]; ++i) {
        Vector3d center_mm = grid.position_mm(i, j, k);
        if (dab.plane_normal) {
          const double off_mm = normal.dot(center_mm - to_mm);
          if (std::abs(off_mm) > thickness_mm * (1 + 1e-12)) continue;
          center_mm -= off_mm * normal;
        }
        const double distance_mm2 = squared_distance_mm2(center_mm, from_mm, to_mm - from_mm);
        if (distance_mm2 > dab.radius_mm * dab.radius_mm * (1 + 1e-12)) continue;
        if (only) {
          const double grey = static_cast<double>(only->image.at(i, j, k));
          if (!(grey >= only->range.low && grey <= only->range.high)) continue;
        }
        mask.at(i, j, k) = value;
      }
    }
  }
  return box;
}

double half_extent_mm(const Grid& grid, const Vector3d& unit_normal) {
  return 0.5 * (grid.direction.transpose() * unit_normal).cwiseAbs().dot(grid.spacing_mm);
}

std::optional<GreyRange> grey_range_at(const imaging::Volume& image, const Vector3d& click_mm,
                                       const LikenessOptions& options) {
  const Grid& grid = image.grid;
  const Vector3d index = grid.index_of(click_mm);
  const Eigen::Vector3i nearest = index.array().round().cast<int>();
  if (!grid.contains(nearest[0], nearest[1], nearest[2])) return std::nullopt;
  const Vector3d reach = Vector3d::Constant(options.around_mm).cwiseQuotient(grid.spacing_mm);
  const IndexBox box = box_around(grid, index - reach, index + reach);
  std::vector<float> near{image.at(nearest[0], nearest[1], nearest[2])};
  for (int k = box.first[2]; k <= box.last[2]; ++k) {
    for (int j = box.first[1]; j <= box.last[1]; ++j) {
      for (int i = box.first[0]; i <= box.last[0]; ++i) {
        if ((grid.position_mm(i, j, k) - click_mm).norm() > options.around_mm) continue;
        near.push_back(image.at(i, j, k));
      }
    }
  }
  std::erase_if(near, [](float value) { return !std::isfinite(value); });
  if (near.empty()) return std::nullopt;
  const double middle = upper_median(near);
  for (float& value : near) value = std::abs(value - static_cast<float>(middle));
  const double deviation = 1.4826 * upper_median(std::move(near));

  // Every so manieth voxel tells the image's range as well.
  constexpr std::size_t enough = 20000;
  std::vector<float> all;
  for (std::size_t voxel = 0; voxel < image.values.size();
       voxel += std::max<std::size_t>(1, image.values.size() / enough)) {
    if (std::isfinite(image.values[voxel])) all.push_back(image.values[voxel]);
  }
  std::sort(all.begin(), all.end());
  const double range = all.empty() ? 0
                                   : static_cast<double>(all[all.size() - 1 - all.size() / 100]) -
                                         static_cast<double>(all[all.size() / 100]);
  const double half = std::max(options.spread * deviation, options.minimum_share * range);
  return GreyRange{middle - half, middle + half};
}

int axis_along(const Grid& grid, const Vector3d& direction) {
  Eigen::Index axis = 0;
  (grid.direction.transpose() * direction).cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis);
}

int layer_at(const Grid& grid, int axis, const Vector3d& place_mm) {
  return static_cast<int>(std::lround(grid.index_of(place_mm)[axis]));
}

namespace {

IndexBox box_around(const Grid& grid, const Vector3d& low_index, const Vector3d& high_index) {
  IndexBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double beyond = grid.size[axis];
    box.first[axis] = static_cast<int>(std::clamp(std::ceil(low_index[a] - 1e-9), 0.0, beyond));
    box.last[axis] = static_cast<int>(std::clamp(std::floor(high_index[a] + 1e-9), -1.0, beyond - 1.0));
  }
  return box;
}

// From the straight way that begins at `from_mm`.
double squared_distance_mm2(const Vector3d& place_mm, const Vector3d& from_mm, const Vector3d& along_mm) {
  const double length_mm2 = along_mm.squaredNorm();
  const double share = length_mm2 > 0 ? std::clamp((place_mm - from_mm).dot(along_mm) / length_mm2, 0.0, 1.0) : 0.0;
  return (place_mm - from_mm - share * along_mm).squaredNorm();
}

}  // namespace
}  // namespace glisson::segmentation
