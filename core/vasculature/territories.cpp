#include "vasculature/territories.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vasculature/internal/march.h"

namespace glisson::vasculature {

using Eigen::Vector3d;

namespace {

// The voxels within a branch's wall, each with how far inside it lies; at least the one that a point falls into.
void add_sources(const TreeBranch& branch, int label, const imaging::Mask& liver, std::vector<Source>& sources) {
  const imaging::Grid& grid = liver.grid;
  for (const CenterPoint& point : branch.points) {
    const Vector3d at = grid.index_of(point.position_mm);
    std::array<int, 3> low{}, high{};
    for (int a = 0; a < 3; ++a) {
      const double reach = std::max(0.5, point.radius_mm / grid.spacing_mm[a]);
      low[static_cast<std::size_t>(a)] = std::max(0, static_cast<int>(std::lround(at[a] - reach)));
      high[static_cast<std::size_t>(a)] =
          std::min(grid.size[static_cast<std::size_t>(a)] - 1, static_cast<int>(std::lround(at[a] + reach)));
    }
    const Vector3d nearest(std::round(at.x()), std::round(at.y()), std::round(at.z()));
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          if (liver.at(i, j, k) == 0) continue;
          const Vector3d way = grid.spacing_mm.cwiseProduct(Vector3d(i, j, k) - at);
          const double beyond = way.norm() - point.radius_mm;
          if (beyond <= 0 || Vector3d(i, j, k) == nearest) {
            sources.push_back(
                {grid.offset(i, j, k), static_cast<float>(beyond), label, point.position_mm, point.radius_mm});
          }
        }
      }
    }
  }
}

// The box around the liver, so that the fronts' memory is that of the liver and not of the image.
imaging::Mask around(const imaging::Mask& liver, std::array<int, 3>& low) {
  const auto& size = liver.grid.size;
  std::array<int, 3> high{-1, -1, -1};
  low = size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (liver.at(i, j, k) == 0) continue;
        low = {std::min(low[0], i), std::min(low[1], j), std::min(low[2], k)};
        high = {std::max(high[0], i), std::max(high[1], j), std::max(high[2], k)};
      }
    }
  }
  imaging::Mask part{liver.grid, {}};
  for (std::size_t a = 0; a < 3; ++a) part.grid.size[a] = std::max(0, high[a] - low[a] + 1);
  part.grid.origin_mm = liver.grid.position_mm(low[0], low[1], low[2]);
  part.values.resize(part.grid.voxels());
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      const std::uint8_t* row = &liver.values[liver.grid.offset(low[0], low[1] + j, low[2] + k)];
      std::copy(row, row + part.grid.size[0], &part.values[part.grid.offset(0, j, k)]);
    }
  }
  return part;
}

}  // namespace

Result<Territories> territories_of(const VesselTrees& trees, System system, const imaging::Mask& liver) {
  if (std::none_of(liver.values.begin(), liver.values.end(), [](std::uint8_t v) { return v != 0; })) {
    return failure("liver-empty", GLISSON_TEXT("The liver mask holds no voxels: mark the liver first."));
  }
  std::array<int, 3> low{};
  const imaging::Mask part = around(liver, low);
  std::vector<Source> sources;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    if (trees.branches[b].system == system) add_sources(trees.branches[b], static_cast<int>(b), part, sources);
  }
  if (sources.empty()) {
    return failure(
        "territories-no-branch",
        GLISSON_TEXT("No branch of the {0} lies in the liver, so that no tissue can be told to be its: check "
                     "that vessels and liver are of one scan."),
        {system_name(system)});
  }
  const Arrivals arrivals = march(part, sources);
  Territories territories{liver.grid, std::vector<std::int32_t>(liver.values.size(), -1),
                          std::vector<float>(liver.values.size(), 0), std::vector<double>(trees.branches.size(), 0)};
  const double voxel_ml = liver.grid.voxel_volume_mm3() / 1000;
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      for (int i = 0; i < part.grid.size[0]; ++i) {
        const std::size_t from = part.grid.offset(i, j, k);
        if (arrivals.label[from] < 0) continue;
        const std::size_t to = liver.grid.offset(low[0] + i, low[1] + j, low[2] + k);
        territories.branch[to] = arrivals.label[from];
        territories.distance_mm[to] = arrivals.mm[from];
        territories.volume_ml[static_cast<std::size_t>(arrivals.label[from])] += voxel_ml;
      }
    }
  }
  return territories;
}

std::vector<double> volumes_beyond_ml(const VesselTrees& trees, const Territories& territories) {
  std::vector<double> volumes = territories.volume_ml;
  for (std::size_t b = trees.branches.size(); b-- > 0;) {  // children come after their parents
    const int parent = trees.branches[b].parent;
    if (parent >= 0) volumes[static_cast<std::size_t>(parent)] += volumes[b];
  }
  return volumes;
}

}  // namespace glisson::vasculature
