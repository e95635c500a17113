#pragma once
// What tells two masks of one grid apart, in few bytes: the voxels to turn, as runs.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// Lengths by turns, from the first voxel on: voxels kept, voxels turned, voxels kept, ... and what follows the last
// length is kept. Empty where nothing differs. Turning twice gives the first mask back, so that one difference serves
// undo and redo.
struct MaskDifference {
  std::vector<std::uint32_t> kept_and_turned;

  [[nodiscard]] bool empty() const { return kept_and_turned.empty(); }
  [[nodiscard]] std::size_t turned_voxels() const;
};

// Values other than 0 count as 1. Both on the same grid (asserts), of at most 2^32 - 1 voxels (asserts).
[[nodiscard]] MaskDifference difference(const imaging::Mask& before, const imaging::Mask& after);

// Turns the voxels of a mask of zeros and ones. The difference must not reach beyond it (asserts).
void turn(imaging::Mask& mask, const MaskDifference& difference);

// As bytes: each length in groups of seven bits, the lowest first, the eighth bit set on all but the last group
// (LEB128). A stroke of the brush takes a few hundred. Reading fails with "difference-damaged" where the bytes end
// within a number or the runs reach beyond `voxels`.
[[nodiscard]] std::string to_bytes(const MaskDifference& difference);
[[nodiscard]] Result<MaskDifference> difference_from_bytes(std::string_view bytes, std::size_t voxels);

}  // namespace glisson::segmentation
