#pragma once
// A liver of which a part is missing (a dome that the image cuts off, a slab of MRE) completed by a shape model.

#include "base/progress.h"
#include "base/result.h"
#include "shapes/shape_fit.h"

namespace glisson::shapes {

struct Completion {
  // Closed, in the patient's frame, with the model's points. The point field "sd_mm" is of the place across the
  // surface. The point field "seen" is 1 where the surface is led by what was seen, which lies there. It is 0 where the
  // model alone leads.
  geometry::Surface surface;
  ShapeFit fit;
  double seen_fraction = 0;  // of the area
};

// Fails with "shapes-outside" where more than 8 mm are left between both, or coefficients lie far outside. That is not
// as the model's livers are, and what the model would add to it is worth nothing.
Result<void> check_inside(const ShapeModel& model, const ShapeFit& fit);

// Refuses with "shapes-mirrored" where the model comes nearer to the mirror image of what is seen than `fit` came to
// it.
Result<void> check_not_mirrored(const ShapeModel& model, const geometry::Surface& seen, const ShapeFit& fit);
// What the model leaves of the mirror image, over what `fit` leaves: below 1 for a liver that is mirrored.
Result<double> mirrored_ratio(const ShapeModel& model, const geometry::Surface& seen, const ShapeFit& fit);

// Failures: those of fit_model. It does not ask check_inside(): whoever shows the answer does.
Result<Completion> complete(const ShapeModel& model, const geometry::Surface& seen, const FitOptions& options = {},
                            const Progress& progress = {});

}  // namespace glisson::shapes
