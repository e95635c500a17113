#pragma once
// A mask carried to another grid.

#include "imaging/image.h"

namespace glisson::segmentation {

// Each voxel of `grid` takes the value of the mask's voxel whose cell its centre lies in; outside the mask, 0.
// Deterministic, whatever the number of threads.
[[nodiscard]] imaging::Mask resample(const imaging::Mask& mask, const imaging::Grid& grid);

}  // namespace glisson::segmentation
