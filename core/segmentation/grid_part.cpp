#include "segmentation/grid_part.h"

#include <cmath>

namespace glisson::segmentation {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

namespace {

Part part_from(const std::array<int, 3>& first, const std::array<int, 3>& last, const Grid& grid) {
  Part part{first, grid};
  for (std::size_t axis = 0; axis < 3; ++axis) part.grid.size[axis] = last[axis] - first[axis] + 1;
  part.grid.origin_mm = grid.position_mm(first[0], first[1], first[2]);
  return part;
}

}  // namespace

Part part_around(const std::vector<Vector3d>& points_mm, double reach_mm, const Grid& grid) {
  std::array<int, 3> first = grid.size, last{-1, -1, -1};
  for (const Vector3d& point_mm : points_mm) {
    const Vector3d index = grid.index_of(point_mm);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      const double reach = reach_mm / grid.spacing_mm[a], end = grid.size[axis] - 1.0;
      first[axis] = std::min(first[axis], static_cast<int>(std::clamp(std::floor(index[a] - reach), 0.0, end)));
      last[axis] = std::max(last[axis], static_cast<int>(std::clamp(std::ceil(index[a] + reach), 0.0, end)));
    }
  }
  return part_from(first, last, grid);
}

Part part_around(const Mask& mask, int rim) {
  std::array<int, 3> first = mask.grid.size, last{-1, -1, -1};
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (mask.at(i, j, k) == 0) continue;
        const std::array<int, 3> here{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          first[axis] = std::min(first[axis], here[axis]);
          last[axis] = std::max(last[axis], here[axis]);
        }
      }
    }
  }
  if (last[0] < 0) return part_from({0, 0, 0}, {0, 0, 0}, mask.grid);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = std::max(first[axis] - rim, 0);
    last[axis] = std::min(last[axis] + rim, mask.grid.size[axis] - 1);
  }
  return part_from(first, last, mask.grid);
}

void put_back(const Mask& piece, const Part& part, Mask& whole) {
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      std::copy_n(piece.values.begin() + static_cast<std::ptrdiff_t>(part.grid.offset(0, j, k)), part.grid.size[0],
                  whole.values.begin() + static_cast<std::ptrdiff_t>(
                                             whole.grid.offset(part.first[0], j + part.first[1], k + part.first[2])));
    }
  }
}

}  // namespace glisson::segmentation
