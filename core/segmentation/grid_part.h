#pragma once
// A part of an image looked at by itself, and put back.

#include <algorithm>
#include <array>
#include <Eigen/Core>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// A part of a grid: as many voxels as `grid` says, from voxel `first` of the whole on.
struct Part {
  std::array<int, 3> first{};
  imaging::Grid grid;
};

// The first part is what lies within `reach_mm` of any of the points along each axis. The second is what the mask
// holds, with a rim of voxels (a mask that holds nothing: its first voxel).
[[nodiscard]] Part part_around(const std::vector<Eigen::Vector3d>& points_mm, double reach_mm,
                               const imaging::Grid& grid);
[[nodiscard]] Part part_around(const imaging::Mask& mask, int rim);

template <typename Value>
imaging::Image<Value> cut_out(const imaging::Image<Value>& whole, const Part& part) {
  imaging::Image<Value> piece{part.grid, std::vector<Value>(part.grid.voxels())};
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      const auto from = whole.values.begin() + static_cast<std::ptrdiff_t>(whole.grid.offset(
                                                   part.first[0], j + part.first[1], k + part.first[2]));
      std::copy_n(from, part.grid.size[0],
                  piece.values.begin() + static_cast<std::ptrdiff_t>(part.grid.offset(0, j, k)));
    }
  }
  return piece;
}

void put_back(const imaging::Mask& piece, const Part& part, imaging::Mask& whole);

}  // namespace glisson::segmentation
