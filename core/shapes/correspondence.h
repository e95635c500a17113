#pragma once
// The same places on different livers: a reference surface moved onto each, point for point, by the project's own
// registration (registration/register.h).

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::shapes {

// The surface whose points every liver is described by: a SIMULATED liver (anatomy/patient.h). So no patient's details
// are in the triangles, and no liver that a model is judged on has shaped them.
Result<geometry::Surface> reference_liver(double spacing_mm = 7);

struct Corresponding {
  geometry::Surface surface;    // the reference's points and triangles, on the liver
  double mean_mm = 0;           // between it and the liver, both ways
  double mirrored_ratio = 0;    // how much worse the liver's mirror image fits the reference, rigidly: 1 as well
  double orientation_kept = 0;  // of the matching by geodesics (registration/geo.h)
};

// TRWL-S matches points by distances along the surfaces and by where they lie (both in LPS); non-rigid ICP follows.
// `liver` must be closed; `coarse` is the same with fewer points, on which the matching is done. Failures:
// "shapes-mirrored" (its mirror image is the better liver), "shapes-outside" (the reference cannot be brought nearer
// than 4 mm on average), those of register_surfaces; "cancelled".
Result<Corresponding> correspond(const geometry::Surface& reference, const geometry::Surface& liver,
                                 const geometry::Surface& coarse, const Progress& progress = {});

}  // namespace glisson::shapes
