#pragma once
// Simple bodies for the pictures of the tests: an organ with a ball and a tube in it.

#include <cmath>
#include <numbers>

#include "geometry/surface.h"
#include "imaging/image.h"
#include "support/shapes.h"

namespace glisson::test {

inline geometry::Surface ellipsoid(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& radii_mm) {
  geometry::Surface surface = sphere_surface(1, 4);
  for (Eigen::Vector3d& point : surface.points_mm) point = center_mm + radii_mm.cwiseProduct(point);
  return surface;
}

// A volume of 64 x 56 x 40 voxels, tilted 12 degrees about the patient's long axis, with a bright ball of 30 mm radius
// about the origin in a dim slope.
inline imaging::Volume tilted_volume() {
  imaging::Volume volume;
  volume.grid.size = {64, 56, 40};
  volume.grid.spacing_mm = {2.5, 2.5, 4};
  const double angle = 12 * std::numbers::pi / 180;
  volume.grid.direction << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  volume.grid.origin_mm =
      -volume.grid.direction * volume.grid.spacing_mm.cwiseProduct(Eigen::Vector3d(31.5, 27.5, 19.5));
  volume.values.resize(volume.grid.voxels());
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 56; ++j) {
      for (int i = 0; i < 64; ++i) {
        const Eigen::Vector3d at = volume.grid.position_mm(i, j, k);
        volume.at(i, j, k) = static_cast<float>(100 + 0.5 * at.x() + (at.norm() < 30 ? 150 : 0));
      }
    }
  }
  return volume;
}

}  // namespace glisson::test
