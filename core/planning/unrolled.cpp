#include "planning/internal/unrolled.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <iterator>
#include <limits>
#include <tuple>

#include "base/parallel.h"

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

using Vessels = std::vector<CutOff::Place>;
using Surfaces = std::vector<const geometry::CutSurface*>;

// Of each surface the branches that it cuts.
std::vector<Vessels> shared_out(const Vessels& cut, const Surfaces& surfaces, const vasculature::VesselTrees& trees);

// How far the nearest tumour is, anywhere; NaN beside the organ. The box around the organ is never filled, so that a
// map costs little while its cut is dragged.
struct Margins {
  const Organ& organ;
  std::vector<float> distance_mm;  // of each voxel of the organ
  [[nodiscard]] double at(const Vector3d& place_mm) const;
};

Resectogram margins_over(const geometry::CutSurface& surface, const Margins& margins, const Vector2d& first_mm,
                         const Vector2d& reach_mm, double step_mm);

// Without the empty rows and columns around what is known.
Resectogram trimmed(const Resectogram& whole);

}  // namespace

std::vector<Resectogram> unrolled(const std::vector<PreparedCut>& cuts, const CutOff& off, const Unrollable& liver,
                                  double step_mm) {
  Surfaces surfaces;
  for (const PreparedCut& cut : cuts) {
    if (cut.surface) surfaces.push_back(&*cut.surface);
  }
  if (surfaces.empty()) return {};
  const Margins margins{liver.organ, distances_mm(liver.organ, liver.tumours)};
  const std::vector<Vessels> vessels = shared_out(off.cut, surfaces, liver.trees);
  std::vector<Resectogram> maps;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const Eigen::AlignedBox2d reach = reach_of(*surfaces[s], liver.organ.grid);
    Resectogram map = margins_over(*surfaces[s], margins, reach.min(), reach.sizes(), step_mm);
    for (const CutOff::Place& cut : vessels[s]) {
      const vasculature::TreeBranch& branch = liver.trees.branches[cut.branch];
      const auto& point = branch.points[cut.point];
      const Vector2d at = (surfaces[s]->across_mm(point.position_mm) - reach.min()) / step_mm;
      map.vessels.push_back({branch.name, at.x(), at.y(), point.radius_mm, branch.system});
    }
    maps.push_back(trimmed(map));
  }
  return maps;
}

namespace {

// A point in a hollow stands for tissue up to 15 mm off; what is cut farther away is another cut's.
std::vector<Vessels> shared_out(const Vessels& cut, const Surfaces& surfaces, const vasculature::VesselTrees& trees) {
  constexpr double reach_mm = 15;
  std::vector<Vessels> shares(surfaces.size());
  for (const CutOff::Place& place : cut) {
    const Vector3d& at_mm = trees.branches[place.branch].points[place.point].position_mm;
    const auto height_mm = [&](const geometry::CutSurface* surface) { return std::abs(surface->height_mm(at_mm)); };
    const auto nearest = std::min_element(surfaces.begin(), surfaces.end(),
                                          [&](const auto* a, const auto* b) { return height_mm(a) < height_mm(b); });
    if (height_mm(*nearest) > reach_mm) continue;
    shares[static_cast<std::size_t>(nearest - surfaces.begin())].push_back(place);
  }
  return shares;
}

// Runs lie in the order of their voxels: that which begins at the voxel or before it on its row holds it, or none does.
double Margins::at(const Vector3d& place_mm) const {
  const Eigen::Vector3i voxel = (organ.grid.index_of(place_mm).array() + 0.5).floor().cast<int>();
  const auto order = [](const Run& run) { return std::tuple(run.k, run.j, run.i); };
  const auto after = std::upper_bound(organ.runs.begin(), organ.runs.end(), std::tuple(voxel.z(), voxel.y(), voxel.x()),
                                      [&](const auto& wanted, const Run& run) { return wanted < order(run); });
  constexpr double beside = std::numeric_limits<double>::quiet_NaN();
  if (after == organ.runs.begin()) return beside;
  const Run& run = *std::prev(after);
  if (run.k != voxel.z() || run.j != voxel.y() || voxel.x() >= run.i + run.length) return beside;
  return static_cast<double>(distance_mm[run.first + static_cast<std::size_t>(voxel.x() - run.i)]);
}

Resectogram margins_over(const geometry::CutSurface& surface, const Margins& margins, const Vector2d& first_mm,
                         const Vector2d& reach_mm, double step_mm) {
  Resectogram map;
  map.step_mm = step_mm;
  const auto axis = [&](const Vector2d& across_mm) -> Vector3d {
    const Vector3d way_mm = surface.on_surface_mm(across_mm) - surface.on_surface_mm({0, 0});
    return (way_mm - way_mm.dot(surface.normal()) * surface.normal()).normalized();
  };
  map.along_row = axis({1, 0}), map.along_column = axis({0, 1});
  map.columns = static_cast<int>(reach_mm.x() / step_mm) + 1;
  map.rows = static_cast<int>(reach_mm.y() / step_mm) + 1;
  map.margin_mm.resize(static_cast<std::size_t>(map.rows) * static_cast<std::size_t>(map.columns));
  parallel_for(static_cast<std::size_t>(map.rows), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (int column = 0; column < map.columns; ++column) {
        const Vector2d across_mm = first_mm + step_mm * Vector2d(column, static_cast<double>(row));
        map.margin_mm[row * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column)] =
            margins.at(surface.on_surface_mm(across_mm));
      }
    }
  });
  return map;
}

Resectogram trimmed(const Resectogram& whole) {
  int left = whole.columns, right = -1, low = whole.rows, high = -1;
  for (int row = 0; row < whole.rows; ++row) {
    for (int column = 0; column < whole.columns; ++column) {
      if (std::isnan(whole.at(column, row))) continue;
      left = std::min(left, column), right = std::max(right, column);
      low = std::min(low, row), high = std::max(high, row);
    }
  }
  Resectogram part{whole.step_mm,
                   std::max(0, right - left + 1),
                   std::max(0, high - low + 1),
                   whole.along_row,
                   whole.along_column,
                   {},
                   whole.vessels};
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
