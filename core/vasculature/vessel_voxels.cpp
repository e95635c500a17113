#include "vasculature/internal/vessel_voxels.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "imaging/filters.h"
#include "segmentation/grid_part.h"

namespace glisson::vasculature {

using Eigen::Vector3d;
using imaging::Mask;

Mask cropped(const Mask& mask) {
  const segmentation::Part around = segmentation::part_around(mask, 0);
  Mask part{around.grid, {}};
  for (int& size : part.grid.size) size += 2;
  part.grid.origin_mm = mask.grid.position_mm(around.first[0] - 1, around.first[1] - 1, around.first[2] - 1);
  part.values.assign(part.grid.voxels(), 0);
  segmentation::put_back(segmentation::cut_out(mask, around), {{1, 1, 1}, around.grid}, part);
  for (std::uint8_t& value : part.values) value = value != 0 ? 1 : 0;
  // A voxel outside with vessel on five of its six sides is a pit of noise.
  const Mask before = part;
  for (int k = 1; k + 1 < part.grid.size[2]; ++k) {
    for (int j = 1; j + 1 < part.grid.size[1]; ++j) {
      for (int i = 1; i + 1 < part.grid.size[0]; ++i) {
        if (before.at(i, j, k) != 0) continue;
        const int sides = before.at(i - 1, j, k) + before.at(i + 1, j, k) + before.at(i, j - 1, k) +
                          before.at(i, j + 1, k) + before.at(i, j, k - 1) + before.at(i, j, k + 1);
        if (sides >= 5) part.at(i, j, k) = 1;
      }
    }
  }
  return part;
}

Voxels::Voxels(const Mask& mask) : grid_(mask.grid), id_(mask.values.size(), -1) {
  const std::vector<float> squared = imaging::squared_depths_mm2(mask);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    if (mask.values[i] == 0) continue;
    id_[i] = static_cast<int>(offset_.size());
    offset_.push_back(i);
    depth_.push_back(std::sqrt(squared[i]));
  }
  std::size_t s = 0;
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        const std::ptrdiff_t row = grid_.size[0], slice = row * grid_.size[1];
        steps_.at(s++) = {i + j * row + k * slice,
                          static_cast<float>(grid_.spacing_mm.cwiseProduct(Vector3d(i, j, k)).norm())};
      }
    }
  }
}

Vector3d Voxels::position_mm(int v) const {
  const std::size_t at = offset_[static_cast<std::size_t>(v)];
  const auto row = static_cast<std::size_t>(grid_.size[0]), column = static_cast<std::size_t>(grid_.size[1]);
  return grid_.position_mm(static_cast<int>(at % row), static_cast<int>(at / row % column),
                           static_cast<int>(at / row / column));
}

Paths paths_along_the_middle(const Voxels& voxels) {
  const std::size_t count = voxels.count();
  Paths paths{std::vector<int>(count, -1), std::vector<float>(count, 0), {}};
  constexpr float unreached = std::numeric_limits<float>::infinity();
  std::vector<float> cost(count, unreached);
  std::vector<char> done(count, 0);
  std::vector<int> deepest_first(count);
  for (std::size_t v = 0; v < count; ++v) deepest_first[v] = static_cast<int>(v);
  std::stable_sort(deepest_first.begin(), deepest_first.end(),
                   [&](int a, int b) { return voxels.depth_mm(a) > voxels.depth_mm(b); });
  const auto dear = [&](int v) { return static_cast<float>(1 / (voxels.depth_mm(v) * voxels.depth_mm(v))); };

  using Waiting = std::pair<float, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  for (const int root : deepest_first) {
    if (cost[static_cast<std::size_t>(root)] != unreached) continue;
    cost[static_cast<std::size_t>(root)] = 0;
    queue.emplace(0.0F, root);
    std::vector<int>& piece = paths.pieces.emplace_back();
    while (!queue.empty()) {
      const auto [reached, v] = queue.top();
      queue.pop();
      if (done[static_cast<std::size_t>(v)] != 0) continue;
      done[static_cast<std::size_t>(v)] = 1;
      piece.push_back(v);
      const float here = dear(v);
      voxels.for_neighbours(v, [&, from = v, so_far = reached](int other, float length) {
        const float offered = so_far + 0.5F * length * (here + dear(other));
        const auto o = static_cast<std::size_t>(other);
        if (offered >= cost[o]) return;
        cost[o] = offered;
        paths.next[o] = from;
        paths.length_mm[o] = paths.length_mm[static_cast<std::size_t>(from)] + length;
        queue.emplace(offered, other);
      });
    }
  }
  std::stable_sort(paths.pieces.begin(), paths.pieces.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return paths;
}

}  // namespace glisson::vasculature
