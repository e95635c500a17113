#pragma once
// Smoothing with a Gaussian of a length in mm, on anisotropic grids.

#include <vector>

#include "imaging/image.h"

namespace glisson::imaging {

// `values`, one a voxel of the grid, convolved with a Gaussian of this standard deviation, cut off at three of them.
// Outside the grid everything is zero: divide by the blurred weights (normalised convolution) where that matters.
// A standard deviation far below the spacing leaves an axis as it is.
[[nodiscard]] std::vector<float> gaussian_blur(std::vector<float> values, const Grid& grid, double sd_mm);

}  // namespace glisson::imaging
