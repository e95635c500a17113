// Flood fill, piece by piece.

#include "segmentation/connected.h"

#include <algorithm>
#include <array>

namespace glisson::segmentation {
namespace {

std::vector<std::array<int, 3>> steps_to(Neighbours neighbours) {
  std::vector<std::array<int, 3>> steps;
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const int away = std::abs(di) + std::abs(dj) + std::abs(dk);
        if (away == 1 || (away > 1 && neighbours == Neighbours::all)) steps.push_back({di, dj, dk});
      }
    }
  }
  return steps;
}

}  // namespace

std::uint32_t ConnectedVoxels::largest() const {
  if (sizes.size() < 2) return 0;
  return static_cast<std::uint32_t>(std::max_element(sizes.begin() + 1, sizes.end()) - sizes.begin());
}

ConnectedVoxels connected_voxels(const imaging::Mask& mask, Neighbours neighbours) {
  const imaging::Grid& grid = mask.grid;
  const std::vector<std::array<int, 3>> steps = steps_to(neighbours);
  ConnectedVoxels found{std::vector<std::uint32_t>(grid.voxels(), 0), {0}};
  std::vector<std::array<int, 3>> waiting;
  std::size_t inside = 0;

  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t first = grid.offset(i, j, k);
        if (mask.values[first] == 0 || found.piece[first] != 0) continue;
        const auto piece = static_cast<std::uint32_t>(found.sizes.size());
        found.piece[first] = piece;
        waiting.assign(1, {i, j, k});
        std::size_t size = 0;
        while (!waiting.empty()) {
          const std::array<int, 3> here = waiting.back();
          waiting.pop_back();
          ++size;
          for (const auto& step : steps) {
            const std::array<int, 3> there{here[0] + step[0], here[1] + step[1], here[2] + step[2]};
            if (!grid.contains(there[0], there[1], there[2])) continue;
            const std::size_t voxel = grid.offset(there[0], there[1], there[2]);
            if (mask.values[voxel] == 0 || found.piece[voxel] != 0) continue;
            found.piece[voxel] = piece;
            waiting.push_back(there);
          }
        }
        found.sizes.push_back(size);
        inside += size;
      }
    }
  }
  found.sizes[0] = grid.voxels() - inside;
  return found;
}

}  // namespace glisson::segmentation
