#pragma once
// One surface of a cut, unrolled.

#include "planning/internal/removal.h"
#include "planning/resectogram.h"

namespace glisson::planning {

// `vessels`: where the surface cuts branches.
[[nodiscard]] Resectogram unrolled(const geometry::CutSurface& surface, const Organ& organ,
                                   const std::vector<TumourSurroundings>& tumours,
                                   const vasculature::VesselTrees& trees, const std::vector<CutOff::Place>& vessels,
                                   double step_mm);

}  // namespace glisson::planning
