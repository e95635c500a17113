#pragma once
// A vessel mask as a list of voxels, and the paths through it that follow the middle of the vessels. Positions in
// patient LPS, mm.

#include <algorithm>
#include <array>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "imaging/image.h"

namespace glisson::vasculature {

// The part of the mask around its voxels, with a border of one that is empty; pits of single voxels are filled.
imaging::Mask cropped(const imaging::Mask& mask);

// The voxels of a mask as a list, each with its depth under the wall and its way to the root of its piece.
class Voxels {
 public:
  explicit Voxels(const imaging::Mask& mask);

  [[nodiscard]] std::size_t count() const { return offset_.size(); }
  [[nodiscard]] Eigen::Vector3d position_mm(int v) const;
  [[nodiscard]] double depth_mm(int v) const { return depth_[static_cast<std::size_t>(v)]; }

  // Calls visit(neighbour, length) for the neighbours in the mask, of 26.
  template <typename Visit>
  void for_neighbours(int v, const Visit& visit) const {
    const std::size_t at = offset_[static_cast<std::size_t>(v)];
    for (const Step& step : steps_) {
      const int other = id_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step.offset)];
      if (other >= 0) visit(other, step.length_mm);
    }
  }
  // Calls visit(voxel) for the mask's voxels in a ball.
  template <typename Visit>
  void for_ball(int center, double radius_mm, const Visit& visit) const;

  [[nodiscard]] const imaging::Grid& grid() const { return grid_; }

 private:
  struct Step {
    std::ptrdiff_t offset;
    float length_mm;
  };
  imaging::Grid grid_;
  std::vector<int> id_;
  std::vector<std::size_t> offset_;
  std::vector<float> depth_;
  std::array<Step, 26> steps_;
};

// Paths through the voxels: for each voxel the next one towards the root of its piece.
struct Paths {
  std::vector<int> next;                 // -1 at a root
  std::vector<float> length_mm;          // to the root
  std::vector<std::vector<int>> pieces;  // voxels in the order in which they were reached; the root first
};
Paths paths_along_the_middle(const Voxels& voxels);

template <typename Visit>
void Voxels::for_ball(int center, double radius_mm, const Visit& visit) const {
  const std::size_t at = offset_[static_cast<std::size_t>(center)];
  const auto row = static_cast<std::size_t>(grid_.size[0]), column = static_cast<std::size_t>(grid_.size[1]);
  const std::array<int, 3> c = {static_cast<int>(at % row), static_cast<int>(at / row % column),
                                static_cast<int>(at / row / column)};
  std::array<int, 3> low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int reach = static_cast<int>(radius_mm / grid_.spacing_mm[static_cast<Eigen::Index>(a)]);
    low[a] = std::max(0, c[a] - reach);
    high[a] = std::min(grid_.size[a] - 1, c[a] + reach);
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        const int other = id_[grid_.offset(i, j, k)];
        if (other < 0) continue;
        const Eigen::Vector3d way = grid_.spacing_mm.cwiseProduct(Eigen::Vector3d(i - c[0], j - c[1], k - c[2]));
        if (way.squaredNorm() <= radius_mm * radius_mm) visit(other);
      }
    }
  }
}

}  // namespace glisson::vasculature
