#pragma once
// How far each voxel is from a mask, exactly, on anisotropic grids.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::imaging {

// For each voxel the squared distance in mm2 from its centre to the centre of the nearest voxel of the mask; infinite
// where the mask is empty. Linear time: lower envelopes of parabolas, axis by axis (Felzenszwalb and Huttenlocher,
// Theory of Computing 8, 2012). The grid's axes are at right angles.
[[nodiscard]] std::vector<float> squared_distances_mm2(const Mask& mask);

// The same, with the offset of that nearest voxel (no_voxel where the mask is empty). Fewer than 2^32 - 1 voxels.
constexpr std::uint32_t no_voxel = 0xffffffffU;
struct NearestVoxels {
  std::vector<float> squared_distance_mm2;
  std::vector<std::uint32_t> offset;
};
[[nodiscard]] NearestVoxels nearest_voxels(const Mask& mask);

}  // namespace glisson::imaging
