#pragma once
// Vessels carried along: from a liver in which they are known into another that corresponds to it point for point.
//
// The surface's points go from one liver to the other in equal steps; at each a thin-plate spline through them takes
// along whatever lies around (registration/thin_plate.h). So short a warp does not fold, nor do several one after the
// other, as one long one does where fissures open (landmarks' flow: Joshi and Miller 2000, IEEE Trans Image Process
// 9:1357). Where the Jacobian J of each keeps its orientation along all vessels, centre lines that did not cross before
// do not cross after. A radius becomes r (det J)^(1/3), so that a vessel keeps its share of the tissue around it; where
// walls that did not touch would, both are narrowed until they do not. Lengths mm.

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "vasculature/systems.h"

namespace glisson::shapes {

// How deep each of the trees' points lies in the closed surface, mm, negative outside; a row a branch.
[[nodiscard]] std::vector<std::vector<double>> depths_mm(const vasculature::VesselTrees& trees,
                                                         const geometry::Surface& liver);

struct LiverWithVessels {
  geometry::Surface surface;  // closed
  vasculature::VesselTrees trees;
  std::vector<std::vector<double>> depth_mm;  // depths_mm(trees, surface)
};

// The SIMULATED liver whose points every shape is described by (reference_liver), with the vessels that grew in it:
// portal and hepatic veins and arteries, down to the last twig, named by its segments. Twigs are cut off where they
// come nearer than `shallow_mm` to the surface, which `spacing_mm` coarsens; vessels that go on below, as in the porta,
// stay. Nobody's anatomy. Failures: those of anatomy::make_patient.
inline constexpr double shallow_mm = 2;
Result<LiverWithVessels> reference_vessels(double spacing_mm = 7, const Progress& progress = {});

// What lies in the first liver lies in the second, this deep at least, or as deep as it lay: what would not is set
// there.
inline constexpr double pulled_under_mm = 0.5;
struct CarriedVessels {
  vasculature::VesselTrees trees;  // branch for branch and point for point those carried, but for what was cut off
  std::vector<std::vector<double>> depth_mm;
  int pulled_in = 0;  // points that were set under the surface, and the farthest of their ways
  double farthest_pulled_mm = 0;
  // Where the surface crosses itself, as drawn ones may, what lies inside cannot be said: points cut off from the ends
  // of twigs there, and points of vessels that go on and lie outside.
  int cut_off = 0, outside = 0;
};

// Into the liver whose points are those of `from` moved. Failures: "vessels-not-corresponding" (other triangles),
// "vessels-fold" (a step turns space inside out where a vessel runs), those of ThinPlateSpline::fit.
Result<CarriedVessels> carry_vessels(const LiverWithVessels& from, const geometry::Surface& to);

}  // namespace glisson::shapes
