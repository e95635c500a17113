#pragma once
// One side of an organ grown by a known factor: all beyond a plane across the patient's left-right axis is drawn out
// along that axis, so that every volume there is the factor times what it was, and nothing else changes.

#include <Eigen/Core>
#include <Eigen/LU>

#include "imaging/image.h"

namespace glisson::test {

struct DrawnOut {
  double from_x_mm = 0;  // to the patient's left of here
  double factor = 1;

  [[nodiscard]] Eigen::Vector3d before(Eigen::Vector3d after_mm) const {
    if (after_mm.x() > from_x_mm) after_mm.x() = from_x_mm + (after_mm.x() - from_x_mm) / factor;
    return after_mm;
  }

  // A grid along the patient's axes that holds all of the other drawn out, as another scan would have it: half a voxel
  // aside, slices thicker by `thicker`.
  [[nodiscard]] imaging::Grid other_grid(const imaging::Grid& grid, double thicker = 1) const {
    Eigen::Vector3d low = grid.position_mm(0, 0, 0), high = low;
    for (int corner = 1; corner < 8; ++corner) {
      const Eigen::Vector3d at =
          grid.position_mm((corner & 1) != 0 ? grid.size[0] - 1 : 0, (corner & 2) != 0 ? grid.size[1] - 1 : 0,
                           (corner & 4) != 0 ? grid.size[2] - 1 : 0);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    if (high.x() > from_x_mm) high.x() = from_x_mm + (high.x() - from_x_mm) * factor;
    imaging::Grid other;
    other.spacing_mm = grid.spacing_mm;
    other.spacing_mm.z() *= thicker;
    other.origin_mm = low - 0.5 * other.spacing_mm;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      other.size[a] = static_cast<int>((high[axis] - other.origin_mm[axis]) / other.spacing_mm[axis]) + 2;
    }
    return other;
  }

  // The nearest voxel of what was.
  template <typename Value>
  [[nodiscard]] imaging::Image<Value> carried(const imaging::Image<Value>& image, const imaging::Grid& to) const {
    imaging::Image<Value> after{to, std::vector<Value>(to.voxels(), Value{0})};
    // As Grid::index_of, whose inverse would be taken at every voxel.
    const imaging::Grid& from = image.grid;
    const Eigen::Matrix3d to_index = from.spacing_mm.cwiseInverse().asDiagonal() * from.direction.inverse();
    for (int k = 0; k < to.size[2]; ++k) {
      for (int j = 0; j < to.size[1]; ++j) {
        for (int i = 0; i < to.size[0]; ++i) {
          const Eigen::Vector3d was_mm = before(to.position_mm(i, j, k));
          const Eigen::Vector3i at = (to_index * (was_mm - from.origin_mm)).array().round().cast<int>();
          if (from.contains(at.x(), at.y(), at.z())) after.at(i, j, k) = image.at(at.x(), at.y(), at.z());
        }
      }
    }
    return after;
  }
};

}  // namespace glisson::test
