#pragma once
// Points that something grows from, checked against the image.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/result.h"
#include "imaging/filters.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// Fails with grow-bad-image (an axis shorter than three voxels).
[[nodiscard]] Result<void> check_image(const imaging::Volume& image);
// The same, and fails with grow-no-seeds and grow-seed-outside (which, how far).
[[nodiscard]] Result<void> check_seeds(const imaging::Volume& image, const std::vector<Eigen::Vector3d>& seeds_mm);

// The voxels whose centre lies within the radius, in the order of the grid.
[[nodiscard]] std::vector<std::size_t> voxels_around(const Eigen::Vector3d& center_mm, double radius_mm,
                                                     const imaging::Grid& grid);

// The indices of a voxel: what Grid::offset() turns into its number.
[[nodiscard]] Eigen::Vector3i index_of(std::size_t voxel, const imaging::Grid& grid);
// The voxel of the mask whose centre is nearest to the place, the first of equal ones; none within the radius.
[[nodiscard]] std::optional<std::size_t> nearest_voxel(const Eigen::Vector3d& place_mm, double radius_mm,
                                                       const imaging::Mask& mask);

// The pieces of the mask that hold one of these voxels.
[[nodiscard]] imaging::Mask joined_to(const std::vector<std::size_t>& voxels, const imaging::Mask& mask,
                                      imaging::Neighbours neighbours = imaging::Neighbours::all);

}  // namespace glisson::segmentation
