#pragma once
// Which voxels of a mask hang together. For use within the room.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

enum class Neighbours { faces, all };  // 6, or 26 with edges and corners

struct ConnectedVoxels {
  std::vector<std::uint32_t> piece;  // of each voxel: 0 outside the mask, else 1, 2, ... in the order of first voxels
  std::vector<std::size_t> sizes;    // sizes[piece]; sizes[0] counts the voxels outside

  // The piece of most voxels, the first of equal ones; 0 where there is none.
  [[nodiscard]] std::uint32_t largest() const;
};

[[nodiscard]] ConnectedVoxels connected_voxels(const imaging::Mask& mask, Neighbours neighbours);

}  // namespace glisson::segmentation
