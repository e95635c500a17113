#pragma once
// The named main branches, as anatomy books draw them, laid into one liver: what finer branches grow from.
//
// Portal vein: a trunk to the porta, then a right and a left branch. The right one has an anterior (V, VIII) and a
// posterior (VI, VII) pedicle. The left one has transverse and umbilical parts, and the branches of I, II, III and IV.
// Hepatic veins: right, middle and left, each in its plane, and one vein of the caudate. Middle and left join before
// the vena cava, as in most people.

#include "anatomy/segments.h"
#include "anatomy/vessel_tree.h"

namespace glisson::anatomy {

// Pedicles end in the middle of their segments. Segments without volume get none.
[[nodiscard]] VesselTree portal_trunk(const LiverBody& liver, const Segments& segments);

// Clear of the portal trunk by `clear_mm` at least, wall to wall, where the plane leaves a way.
[[nodiscard]] VesselTree hepatic_trunk(const LiverBody& liver, const Segments& segments, const VesselTree& portal,
                                       double root_radius_mm);

}  // namespace glisson::anatomy
