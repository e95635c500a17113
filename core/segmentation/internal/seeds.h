#pragma once
// Points that something grows from, checked against the image.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// Fails with grow-bad-image (an axis shorter than three voxels).
[[nodiscard]] Result<void> check_image(const imaging::Volume& image);
// The same, and fails with grow-no-seeds and grow-seed-outside (which, how far).
[[nodiscard]] Result<void> check_seeds(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm);

// The voxels whose centre lies within the radius, in the order of the grid.
[[nodiscard]] std::vector<std::size_t> voxels_around(const Eigen::Vector3d& center_mm, double radius_mm,
                                                     const imaging::Grid& grid);

// The pieces of the mask (26 neighbours) that hold one of these voxels.
[[nodiscard]] imaging::Mask joined_to(const std::vector<std::size_t>& voxels, const imaging::Mask& mask);

}  // namespace glisson::segmentation
