#pragma once
// The voxels of an organ by number, without the image around it.

#include <cmath>
#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::planning {

// Voxels beside each other along i.
struct Run {
  int i = 0, j = 0, k = 0;
  int length = 0;
  std::size_t first = 0;  // the number of its first voxel
};

struct Organ {
  imaging::Grid grid;  // the box around it
  std::vector<Run> runs;
  std::size_t voxels = 0;

  [[nodiscard]] double voxel_ml() const { return grid.voxel_volume_mm3() / 1000; }
  // The side of a cube of a voxel's volume.
  [[nodiscard]] double voxel_mm() const { return std::cbrt(grid.voxel_volume_mm3()); }
};

[[nodiscard]] Organ organ_of(const imaging::Mask& mask);

// Of each voxel of the box; -1 beside the organ.
[[nodiscard]] std::vector<std::int32_t> numbers_in(const Organ& organ);

// Where each voxel lies in the box.
[[nodiscard]] std::vector<std::uint32_t> places_in(const Organ& organ);

// Calls take(number, value) for each voxel of the organ whose nearest voxel in `image` there is.
template <typename Value, typename Take>
void sample(const Organ& organ, const imaging::Image<Value>& image, std::size_t first_run, std::size_t last_run,
            const Take& take) {
  const Eigen::Vector3d origin = image.grid.index_of(organ.grid.position_mm(0, 0, 0));
  Eigen::Matrix3d steps;
  for (int a = 0; a < 3; ++a) {
    steps.col(a) = image.grid.index_of(organ.grid.position_mm(Eigen::Vector3d::Unit(a))) - origin;
  }
  for (std::size_t r = first_run; r < last_run; ++r) {
    const Run& run = organ.runs[r];
    const Eigen::Vector3d start = origin + steps * Eigen::Vector3d(run.i, run.j, run.k);
    for (int n = 0; n < run.length; ++n) {
      const Eigen::Vector3d at = start + n * steps.col(0);
      const int i = static_cast<int>(std::floor(at.x() + 0.5)), j = static_cast<int>(std::floor(at.y() + 0.5)),
                k = static_cast<int>(std::floor(at.z() + 0.5));
      if (image.grid.contains(i, j, k)) take(run.first + static_cast<std::size_t>(n), image.at(i, j, k));
    }
  }
}

}  // namespace glisson::planning
