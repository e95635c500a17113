#pragma once
// Between a fine grid and a coarser one over the same space.

#include <array>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// How many voxels along each axis make one of about `spacing_mm`; at least one.
[[nodiscard]] std::array<int, 3> blocks_of(const imaging::Grid& grid, double spacing_mm);

// Means of blocks of voxels; values that are not finite do not count, and a block of nothing else is NaN. The last
// block of an axis may be cut short.
[[nodiscard]] imaging::Image<float> block_means(const imaging::Grid& grid, const std::vector<float>& values,
                                                const std::array<int, 3>& block);

// The blocks of which the mask holds half or more.
[[nodiscard]] imaging::Mask block_majority(const imaging::Mask& mask, const std::array<int, 3>& block);

// The coarse values on the fine grid, by trilinear interpolation; beyond the outermost centres the nearest value.
[[nodiscard]] std::vector<float> interpolated(const imaging::Image<float>& coarse, const imaging::Grid& fine,
                                              const std::array<int, 3>& block);

}  // namespace glisson::segmentation
