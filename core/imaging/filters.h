#pragma once
// The filters of images that more than one room needs, by ITK, on anisotropic grids whose axes are at right angles.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::imaging {

// `values`, one a voxel of the grid, smoothed with a Gaussian of this standard deviation (recursive, after Deriche:
// within 1 % of the exact one). Beyond the grid its outermost values go on; for what is unknown outside a region,
// divide by the smoothed weights (normalised convolution). An axis is left as it is where the standard deviation is
// below a third of the spacing, or where it has fewer than four voxels.
[[nodiscard]] std::vector<float> gaussian_blur(std::vector<float> values, const Grid& grid, double sd_mm);

// For each voxel the squared distance in mm2 from its centre to the centre of the nearest voxel of the mask. It is 0
// inside the mask, and infinite where the mask is empty. Exact (Maurer, Qi and Raghavan, IEEE PAMI 25:265, 2003).
[[nodiscard]] std::vector<float> squared_distances_mm2(const Mask& mask);
// The same to the nearest voxel that is not of the mask, 0 outside it; infinite where the mask is all of the image.
[[nodiscard]] std::vector<float> squared_depths_mm2(const Mask& mask);

// Which voxels of a mask hang together.
enum class Neighbours { faces, all };  // 6, or 26 with edges and corners

struct ConnectedVoxels {
  std::vector<std::uint32_t> piece;  // of each voxel: 0 outside the mask, else 1, 2, ...
  std::vector<std::size_t> sizes;    // sizes[piece]; sizes[0] counts the voxels outside

  // The piece of most voxels, the first of equal ones; 0 where there is none.
  [[nodiscard]] std::uint32_t largest() const;
};
[[nodiscard]] ConnectedVoxels connected_voxels(const Mask& mask, Neighbours neighbours);

// The mask and all of its outside that does not reach the grid's border by faces.
[[nodiscard]] Mask fill_holes(const Mask& mask);

}  // namespace glisson::imaging
