#pragma once
// The scan itself, as soft light behind what was outlined in it: bones, vessels and kidneys say where in the body the
// organ lies. Values; a Painter draws it.

#include <cstdint>
#include <memory>
#include <vector>

#include "imaging/image.h"

namespace glisson::scene {

// Clear up to the value `low`, as dense as a backdrop gets from `high` on, both in the volume's unit.
struct Backdrop {
  std::shared_ptr<const imaging::Volume> volume;
  double low = 0;
  double high = 1;
};

// Bone and what contrast medium fills, in Hounsfield units: soft tissue without it (about 40 to 120) stays clear.
[[nodiscard]] Backdrop ct_backdrop(std::shared_ptr<const imaging::Volume> volume);

// The brightest fifth of the values that are not the darkest one: MR has no fixed scale, and air around the body fills
// much of its image.
[[nodiscard]] Backdrop backdrop_by_brightness(std::shared_ptr<const imaging::Volume> volume);

// Means over blocks of whole voxels, so that no side has more than `largest_side`, as 0 (`low` and less) to 255 (`high`
// and more). Blocks at the far edges may be cut off; the grid's origin is the middle of the first block.
struct CoarseBackdrop {
  imaging::Grid grid;
  std::vector<std::uint8_t> values;  // x fastest
};
[[nodiscard]] CoarseBackdrop coarsened(const Backdrop& backdrop, int largest_side);

}  // namespace glisson::scene
