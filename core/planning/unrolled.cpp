#include "planning/internal/unrolled.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

namespace glisson::planning {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Of each voxel, how far the nearest tumour is.
std::vector<float> distances_mm(const Organ& organ, const std::vector<TumourSurroundings>& tumours) {
  std::vector<float> distance_mm(organ.voxels, static_cast<float>(largest_margin_mm));
  for (const TumourSurroundings& tumour : tumours) {
    for (const std::uint32_t voxel : tumour.voxels) distance_mm[voxel] = 0;
    for (const auto& near : tumour.around)
      distance_mm[near.voxel] = std::min(distance_mm[near.voxel], near.distance_mm);
  }
  return distance_mm;
}

// What of the surface's axes the organ's box spans.
Eigen::AlignedBox2d reach_of(const geometry::CutSurface& surface, const imaging::Grid& box) {
  Eigen::AlignedBox2d reach;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d index((corner & 1) != 0 ? box.size[0] - 1 : 0, (corner & 2) != 0 ? box.size[1] - 1 : 0,
                         (corner & 4) != 0 ? box.size[2] - 1 : 0);
    reach.extend(surface.across_mm(box.position_mm(index)));
  }
  return reach;
}

// Without the empty rows and columns around what is known.
Resectogram trimmed(const Resectogram& whole);

}  // namespace

Resectogram unrolled(const geometry::CutSurface& surface, const Organ& organ,
                     const std::vector<TumourSurroundings>& tumours, const vasculature::VesselTrees& trees,
                     const std::vector<CutOff::Place>& vessels, double step_mm) {
  const std::vector<float> distance_mm = distances_mm(organ, tumours);
  const std::vector<std::int32_t> numbers = numbers_in(organ);
  const Eigen::AlignedBox2d reach = reach_of(surface, organ.grid);
  Resectogram map;
  map.step_mm = step_mm;
  map.columns = static_cast<int>(reach.sizes().x() / step_mm) + 1;
  map.rows = static_cast<int>(reach.sizes().y() / step_mm) + 1;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const Vector3d place_mm = surface.on_surface_mm(reach.min() + step_mm * Vector2d(column, row));
      const Eigen::Vector3i at = (organ.grid.index_of(place_mm).array() + 0.5).floor().cast<int>();
      const std::int32_t voxel =
          organ.grid.contains(at.x(), at.y(), at.z()) ? numbers[organ.grid.offset(at.x(), at.y(), at.z())] : -1;
      map.margin_mm.push_back(voxel < 0 ? std::numeric_limits<double>::quiet_NaN()
                                        : static_cast<double>(distance_mm[static_cast<std::size_t>(voxel)]));
    }
  }
  for (const CutOff::Place& cut : vessels) {
    const auto& point = trees.branches[cut.branch].points[cut.point];
    const Vector2d at = (surface.across_mm(point.position_mm) - reach.min()) / step_mm;
    map.vessels.push_back({trees.branches[cut.branch].name, at.x(), at.y(), point.radius_mm});
  }
  return trimmed(map);
}

namespace {

Resectogram trimmed(const Resectogram& whole) {
  int left = whole.columns, right = -1, low = whole.rows, high = -1;
  for (int row = 0; row < whole.rows; ++row) {
    for (int column = 0; column < whole.columns; ++column) {
      if (std::isnan(whole.at(column, row))) continue;
      left = std::min(left, column), right = std::max(right, column);
      low = std::min(low, row), high = std::max(high, row);
    }
  }
  Resectogram part{whole.step_mm, std::max(0, right - left + 1), std::max(0, high - low + 1), {}, whole.vessels};
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column) part.margin_mm.push_back(whole.at(column, row));
  }
  for (Resectogram::Vessel& vessel : part.vessels) {
    vessel.column -= left;
    vessel.row -= low;
  }
  return part;
}

}  // namespace
}  // namespace glisson::planning
