#pragma once
// The border of an outline put where brightness is half way between both sides.

#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// The mean of the values that count, in Gaussian surroundings; NaN where none is near. One count, 0 to 1, a voxel. In
// voxels much smaller than the deviation it is worked out in blocks of half of that, and read between them.
[[nodiscard]] std::vector<float> local_mean(const imaging::Image<float>& image, const std::vector<float>& counts,
                                            double sd_mm);

// A voxel at the border is a mixture of both sides. It joins the side whose brightness near by is nearer to its own,
// where both differ by six of the organ's deviations or more: with less, noise would decide. Voxels move by at most
// one.
[[nodiscard]] imaging::Mask at_half_step(imaging::Mask outline, const imaging::Volume& image, double organ_sd);

}  // namespace glisson::segmentation
