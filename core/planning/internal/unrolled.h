#pragma once
// The surfaces of a plan's cuts, unrolled.

#include "planning/internal/removal.h"
#include "planning/resectogram.h"

namespace glisson::planning {

// What a map tells of a liver.
struct Unrollable {
  const Organ& organ;
  const std::vector<TumourSurroundings>& tumours;
  const vasculature::VesselTrees& trees;
};

// Of each plane and sheet among the cuts, in order. `off`: which branches the cuts go through; each stands on the
// surface that it is cut nearest to.
[[nodiscard]] std::vector<Resectogram> unrolled(const std::vector<PreparedCut>& cuts, const CutOff& off,
                                                const Unrollable& liver, double step_mm);

}  // namespace glisson::planning
