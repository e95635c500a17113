#pragma once
// A sampled quantity in space: a grid of voxels with its place in the patient, and a value for each voxel.
//
// Frame: patient coordinates, LPS (x to the patient's left, y to the back, z to the head), in mm.
// Shape: voxel (i, j, k) stands at values[i + size[0] * (j + size[1] * k)]; i runs along a row.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/LU>
#include <string>
#include <vector>

namespace glisson::imaging {

struct Grid {
  std::array<int, 3> size{0, 0, 0};
  Eigen::Vector3d spacing_mm{1, 1, 1};
  Eigen::Vector3d origin_mm{0, 0, 0};                       // centre of voxel (0, 0, 0)
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();  // columns: unit vectors of the i, j, k axes

  [[nodiscard]] std::size_t voxels() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  // Axes that are not square to each other (gantry tilt) span less than the product of the spacings.
  [[nodiscard]] double voxel_volume_mm3() const { return spacing_mm.prod() * std::abs(direction.determinant()); }
  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
  }
  [[nodiscard]] bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }

  // Patient position of a (fractional) voxel index, and back.
  [[nodiscard]] Eigen::Vector3d position_mm(const Eigen::Vector3d& index) const {
    return origin_mm + direction * spacing_mm.cwiseProduct(index);
  }
  [[nodiscard]] Eigen::Vector3d position_mm(int i, int j, int k) const { return position_mm(Eigen::Vector3d(i, j, k)); }
  [[nodiscard]] Eigen::Vector3d index_of(const Eigen::Vector3d& position_mm) const {
    return (direction.inverse() * (position_mm - origin_mm)).cwiseQuotient(spacing_mm);
  }
};

// Same size, and every voxel of one within tolerance_mm of the same voxel of the other.
[[nodiscard]] bool same_grid(const Grid& a, const Grid& b, double tolerance_mm = 1e-3);

template <typename Value>
struct Image {
  Grid grid;
  std::vector<Value> values;

  [[nodiscard]] Value at(int i, int j, int k) const { return values[grid.offset(i, j, k)]; }
  [[nodiscard]] Value& at(int i, int j, int k) { return values[grid.offset(i, j, k)]; }
};

// A measured quantity. `unit` is "HU", "kPa", "Pa", "rad", "um", or empty for arbitrary units.
struct Volume : Image<float> {
  std::string unit;
};

// Which voxels belong to something: 0 or 1.
using Mask = Image<std::uint8_t>;

// Which of several structures each voxel belongs to; 0 is none.
using LabelMap = Image<std::uint16_t>;

}  // namespace glisson::imaging
