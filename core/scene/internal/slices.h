#pragma once
// What slices of a scan have in common, whatever picture they are in.

#include "scene/scene.h"
#include "segmentation/structures.h"

namespace glisson::scene {

// The window in which a radiologist would look: from the 2nd to the 99.5th percentile of what is there.
void set_grey_window(SliceItem& slice);

// A structure's outline in its own colour.
[[nodiscard]] MaskLine outline_of(segmentation::Structure structure);

}  // namespace glisson::scene
