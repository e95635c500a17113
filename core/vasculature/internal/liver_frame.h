#pragma once
// Where things lie in a liver, as far as its shape alone says: a box around it.
//
// Frame: patient coordinates, LPS, mm.

#include <Eigen/Core>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::vasculature {

// The box holds all but 1 % of the liver at each side.
struct LiverFrame {
  Eigen::Vector3d low_mm{0, 0, 0}, high_mm{0, 0, 0}, centroid_mm{0, 0, 0};
  double volume_ml = 0;

  // (0, 0, 0) is right, front and below; (1, 1, 1) left, back and above.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& share) const {
    return low_mm + share.cwiseProduct(high_mm - low_mm);
  }
  // About 1 for 1500 ml.
  [[nodiscard]] double scale() const;
};

// Fails with liver-empty and liver-cut-off (the image ends within it).
Result<LiverFrame> liver_frame(const imaging::Mask& liver);

}  // namespace glisson::vasculature
