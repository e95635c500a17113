#pragma once
// Straight vessels of known calibre, drawn into a mask.

#include <algorithm>
#include <Eigen/Core>

#include "imaging/image.h"

namespace glisson::vasculature::test {

// A cylinder with round ends.
inline void draw(imaging::Mask& mask, const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, double radius_mm) {
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        const Eigen::Vector3d p = mask.grid.position_mm(i, j, k), way = to_mm - from_mm;
        const double t = std::clamp((p - from_mm).dot(way) / way.squaredNorm(), 0.0, 1.0);
        if ((p - from_mm - t * way).norm() <= radius_mm) mask.at(i, j, k) = 1;
      }
    }
  }
}

}  // namespace glisson::vasculature::test
