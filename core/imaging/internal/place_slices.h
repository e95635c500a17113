#pragma once
// The grid that a stack of slices fills in the patient.

#include <string>
#include <vector>

#include "imaging/image.h"
#include "imaging/internal/slice_spacing.h"
#include "imaging/internal/stacks.h"

namespace glisson::imaging {

struct PlacedSlices {
  Grid grid;                       // under gantry tilt its third axis leans the way the slices do
  std::vector<SliceBlend> slices;  // one for each k of the grid
  std::vector<std::string> problems;
};

// By the first volume; the others stand at the same positions.
[[nodiscard]] PlacedSlices place_slices(const std::vector<DicomImage>& images, const Volumes& volumes);

}  // namespace glisson::imaging
