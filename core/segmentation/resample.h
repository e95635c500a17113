#pragma once
// A mask or an image carried to another grid.

#include "imaging/image.h"

namespace glisson::segmentation {

// Each voxel of `grid` takes the value of the mask's voxel whose cell its centre lies in; outside the mask, 0.
// Deterministic, whatever the number of threads.
[[nodiscard]] imaging::Mask resample(const imaging::Mask& mask, const imaging::Grid& grid);

// At a (fractional) voxel index, between the voxels' centres, trilinear; beyond the outermost ones the nearest value.
[[nodiscard]] double value_between(const imaging::Image<float>& image, const Eigen::Vector3d& index);

// The same at every voxel of a grid. A value that is not finite spreads to where it weighs.
[[nodiscard]] imaging::Image<float> resample(const imaging::Image<float>& image, const imaging::Grid& grid);

}  // namespace glisson::segmentation
