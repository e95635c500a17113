#pragma once
// How far each voxel is from a mask's border.

#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// From a voxel's centre to the nearest centre on the other side, in mm, negative inside; infinite where there is no
// other side. The image's border does not count as outside.
[[nodiscard]] std::vector<float> signed_distances_mm(const imaging::Mask& mask);

}  // namespace glisson::segmentation
