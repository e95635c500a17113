#pragma once
// Label maps of shapes whose volume is known.

#include <Eigen/Geometry>

#include "imaging/image.h"

namespace glisson::test {

// A grid of cubic voxels around the origin of the patient, half_width_mm to each side.
inline imaging::LabelMap empty_labels(double spacing_mm, double half_width_mm) {
  imaging::LabelMap labels;
  const int voxels = 2 * static_cast<int>(half_width_mm / spacing_mm) + 1;
  labels.grid.size = {voxels, voxels, voxels};
  labels.grid.spacing_mm = Eigen::Vector3d::Constant(spacing_mm);
  labels.grid.origin_mm = Eigen::Vector3d::Constant(-spacing_mm * (voxels - 1) / 2);
  labels.values.assign(labels.grid.voxels(), 0);
  return labels;
}

// Gives the label to every voxel whose centre `holds` (a position in the patient, mm).
template <typename Holds>
void paint(imaging::LabelMap& labels, std::uint16_t label, Holds&& holds) {
  const auto& size = labels.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (holds(labels.grid.position_mm(i, j, k))) labels.at(i, j, k) = label;
      }
    }
  }
}

inline void paint_ball(imaging::LabelMap& labels, std::uint16_t label, const Eigen::Vector3d& center_mm,
                       double radius_mm) {
  paint(labels, label, [&](const Eigen::Vector3d& at) { return (at - center_mm).norm() < radius_mm; });
}

}  // namespace glisson::test
