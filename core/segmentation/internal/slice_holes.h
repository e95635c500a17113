#pragma once
// Holes that are closed within a slice, as a vessel's cross-section is.

#include "imaging/image.h"

namespace glisson::segmentation {

// Fills what is enclosed (by faces) within a slice across any of the three axes and no larger than a disc of this
// radius. A vessel that enters from outside is no hole in space but is one in the slices that it crosses.
[[nodiscard]] imaging::Mask with_slice_holes_filled(const imaging::Mask& mask, double radius_mm);

}  // namespace glisson::segmentation
