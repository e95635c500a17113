#pragma once
// Points that something grows from, checked against the image.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// Fails with grow-bad-image (an axis shorter than three voxels), grow-no-seeds, grow-seed-outside (which, how far).
[[nodiscard]] Result<void> check_seeds(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm);

// The voxels whose centre lies within the radius, in the order of the grid.
[[nodiscard]] std::vector<std::size_t> voxels_around(const Eigen::Vector3d& center_mm, double radius_mm,
                                                     const imaging::Grid& grid);

}  // namespace glisson::segmentation
