#include "segmentation/part_at_neck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <vector>

#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/seeds.h"

namespace glisson::segmentation {
namespace {

using imaging::Grid;
using imaging::Mask;

// Voxels to be flooded, the deepest first; of equal ones, those that were reached first.
struct Reached {
  float depth_mm;
  std::size_t turn, voxel;
  bool operator<(const Reached& other) const {
    return depth_mm != other.depth_mm ? depth_mm < other.depth_mm : turn > other.turn;
  }
};

struct Depths {
  Grid grid;
  std::vector<float> mm;  // 0 outside

  template <typename Visit>
  void for_each_neighbour(std::size_t voxel, const Visit& visit) const {
    const Eigen::Vector3i at = index_of(voxel, grid);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Eigen::Vector3i next = at;
        next[axis] += step;
        if (!grid.contains(next[0], next[1], next[2])) continue;
        const std::size_t neighbour = grid.offset(next[0], next[1], next[2]);
        if (mm[neighbour] > 0) visit(neighbour);
      }
    }
  }
};

Depths depths_of(const Mask& mask) {
  Depths depths{mask.grid, imaging::squared_depths_mm2(mask)};
  for (float& depth : depths.mm) depth = std::sqrt(depth);
  return depths;
}

// The middle of the part that a voxel lies in: flooded from there, the deepest voxel before the flood comes through a
// neck to deeper ones. Nothing where it comes to the middle of the whole without one.
std::optional<std::size_t> middle_of_part_at(const Depths& depths, std::size_t start, std::size_t main,
                                             double maximum_share) {
  std::vector<std::uint8_t> seen(depths.mm.size(), 0);
  std::priority_queue<Reached> open;
  std::size_t turn = 0, middle = start;
  float shallowest_since = depths.mm[start];
  open.push({depths.mm[start], turn, start});
  seen[start] = 1;
  while (!open.empty()) {
    const Reached next = open.top();
    open.pop();
    shallowest_since = std::min(shallowest_since, next.depth_mm);
    if (next.voxel == main || next.depth_mm > depths.mm[middle]) {
      if (shallowest_since <= maximum_share * static_cast<double>(depths.mm[middle])) return middle;
      middle = next.voxel;
      shallowest_since = next.depth_mm;
    }
    if (next.voxel == main) return std::nullopt;
    depths.for_each_neighbour(next.voxel, [&](std::size_t neighbour) {
      if (seen[neighbour] != 0) return;
      seen[neighbour] = 1;
      open.push({depths.mm[neighbour], ++turn, neighbour});
    });
  }
  return middle;  // a separate piece
}

// 1 where the flood from the first is there sooner, 2 where that from the second is, 0 where neither comes.
std::vector<std::uint8_t> flooded_from(const Depths& depths, std::array<std::size_t, 2> middles) {
  std::vector<std::uint8_t> flood(depths.mm.size(), 0);
  std::priority_queue<Reached> open;
  std::size_t turn = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    flood[middles[n]] = static_cast<std::uint8_t>(n + 1);
    open.push({depths.mm[middles[n]], ++turn, middles[n]});
  }
  while (!open.empty()) {
    const std::size_t voxel = open.top().voxel;
    open.pop();
    depths.for_each_neighbour(voxel, [&](std::size_t neighbour) {
      if (flood[neighbour] != 0) return;
      flood[neighbour] = flood[voxel];
      open.push({depths.mm[neighbour], ++turn, neighbour});
    });
  }
  return flood;
}

}  // namespace

Result<Mask> without_part_at(Mask mask, const Eigen::Vector3d& place_mm, const NeckOptions& options) {
  const auto voxel = voxel_held_at(mask, place_mm);
  if (!voxel) return failure(voxel.error());
  const Part part = part_around(mask, 1);
  Mask piece = cut_out(mask, part);
  const Depths depths = depths_of(piece);
  const auto main = static_cast<std::size_t>(std::max_element(depths.mm.begin(), depths.mm.end()) - depths.mm.begin());
  const Eigen::Vector3i here = *voxel - Eigen::Vector3i(part.first[0], part.first[1], part.first[2]);
  const auto middle =
      middle_of_part_at(depths, piece.grid.offset(here[0], here[1], here[2]), main, options.maximum_share);
  if (!middle || std::isinf(depths.mm[main])) {  // the whole image has no border to be narrow between
    return failure("edit-no-neck",
                   GLISSON_TEXT("Nothing narrower joins this place to the rest of the structure: cut it off with the "
                                "scissors, or click farther out."));
  }
  const std::vector<std::uint8_t> flood = flooded_from(depths, {*middle, main});
  for (std::size_t n = 0; n < flood.size(); ++n)
    if (flood[n] == 1) piece.values[n] = 0;
  put_back(piece, part, mask);
  return mask;
}

}  // namespace glisson::segmentation
