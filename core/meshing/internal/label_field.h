#pragma once
// The labels between voxel centres: which piece a point belongs to, with smooth boundaries instead of voxel steps.

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "meshing/label_pieces.h"

namespace glisson::meshing {

// A point belongs to the piece of which it sees most through a small window. The indicator of each piece is 1 in its
// voxels and 0 elsewhere. It is blurred with the weights 1/4, 1/2, 1/4 along each axis, and interpolated linearly.
//
// Blurring alone would shrink what is small (a sphere of 5 voxels by 8 % of its volume) and lose what is one voxel
// thin. So each inner piece is weighted by (1 - level) / level. `level` is a value of its blurred indicator: as much
// volume lies above it as the piece has. A plane boundary stays where it is, midway between voxel centres.
class LabelField {
 public:
  explicit LabelField(const PieceMap& map);

  // 0 outside, else 1 + the index of the piece. The point is in the grid's own frame: spacing times voxel index, in mm.
  [[nodiscard]] int piece_at(const Eigen::Vector3d& local_mm) const;

  [[nodiscard]] const PieceMap& map() const { return *map_; }

 private:
  // The pieces seen from a point and how much of each. A window of 64 voxels never shows more than these in real
  // anatomy; what comes after them is not counted.
  struct View {
    std::array<std::uint16_t, 8> piece;
    std::array<double, 8> share;
    std::size_t pieces = 0;
    void add(std::uint16_t number, double weight);
  };
  [[nodiscard]] View view_from(const Eigen::Vector3d& index) const;
  void find_uniform_windows();
  void weigh_inner_pieces();

  const PieceMap* map_;
  std::vector<std::uint8_t>
      uniform_;  // a voxel (i, j, k): the window of points between it and (i+1, j+1, k+1) shows one piece
  std::vector<double> weight_;  // by piece number
};

}  // namespace glisson::meshing
