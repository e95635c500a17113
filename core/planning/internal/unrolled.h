#pragma once
// One surface of a cut, unrolled.

#include "planning/internal/removal.h"
#include "planning/resectogram.h"

namespace glisson::planning {

// `vessels`: where branches are cut; those within a few millimetres of the surface are shown.
[[nodiscard]] Resectogram unrolled(const geometry::CutSurface& surface, const Organ& organ,
                                   const std::vector<TumourSurroundings>& tumours,
                                   const vasculature::VesselTrees& trees, const CutOff& vessels, double step_mm);

}  // namespace glisson::planning
