#pragma once
// How far a tumour is from the cut, which lies between the voxels that go and those that stay.

#include <vector>

#include "planning/internal/removal.h"
#include "planning/planner.h"

namespace glisson::planning {

// Of the tumour of that number, mm; "at least" where nothing on the other side lies within largest_margin_mm.
[[nodiscard]] MarginAnswer margin_to_cut(std::size_t number, const Removal& removal, const Organ& organ,
                                         const std::vector<TumourSurroundings>& tumours);

}  // namespace glisson::planning
