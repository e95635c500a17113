#pragma once
// The hepatic artery's main branches, in the portal vein's sheath: what finer arteries grow from.

#include "anatomy/vessel_tree.h"

namespace glisson::anatomy {

// Beside each branch of the portal trunk, on the side that its divisions leave free: to the left and in front where it
// enters. A branch that would meet either vein is left out, with all beyond it; other branches feed its segment.
[[nodiscard]] VesselTree artery_trunk(const VesselTree& portal, const VesselTree& hepatic, double artery_radius_mm);

}  // namespace glisson::anatomy
