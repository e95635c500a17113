#pragma once
// The liver found in an image by brightness and shape together: from points inside and outside it, or from none.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"
#include "segmentation/cut_by_shape.h"
#include "segmentation/grow.h"
#include "segmentation/taken_off.h"
#include "shapes/model_placing.h"
#include "shapes/shape_fit.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

struct FindOptions {
  double working_spacing_mm = 3;
  double smoothing_mm = 2.5;  // standard deviation of the Gaussian in which a voxel is judged
  double placing_sd_mm = 12;  // of a border of the liver that was placed by the search
  double clear = 0.7;         // log-likelihood on either side of a border that the shape is fitted to
  double minimum_seen = 0.1;  // share of such borders, else there is no liver
  // The shape is fitted once for each reach: how far from it a border is looked for. Then both are cut together, the
  // border expected with the fit's deviation and so much more.
  struct Round {
    std::vector<double> reaches_mm;
    double more_mm;
  };
  std::vector<Round> rounds{{{36, 30, 24}, 6}, {{30, 20}, 4}, {{20, 15}, 3}};
  PlacingOptions placing;
  FitOptions fit{.independent = 150, .iterations = 12};
  segmentation::ShapeCutOptions cut;
};

struct FoundLiver {
  segmentation::GrowResult liver;
  bool by_brightness_alone = false;  // it is what grew: no shape had a surer border
  ShapeFit fit;                      // without points where no shape was found
  double placing_score = 0;          // Placing::score
  double seen_fraction = 0;          // of the shape's surface: where the image shows a border by itself
};

// The model's mean is placed by a search (model_placing.h). In rounds: the shape is fitted to the borders that the
// image shows by itself near it (shape_fit.h; searched along normals, Cootes et al. 1995). Brightness and the border
// that the shape expects, with its deviation, are cut together (segmentation/cut_by_shape.h), from which both sides'
// brightness is learnt anew. At last the border is put on the image's own grid. What grows (grow.h) from the points
// inside or, without any, from one in the middle of what was found, is a second start, and a third answer; that with
// the surest border (unsure_border.h) is taken.
// What lies around points outside is taken off it at last (taken_off.h). Deterministic, whatever the number of threads.
//
// Fails with "grow-seed-outside" (a point beside the image). Where nothing grows, fails as place_model() and
// fit_model() do, with "shapes-no-liver-found" also where the shape that comes out is not as the model's, or the image
// shows less than a tenth of its border.
Result<FoundLiver> find_liver(const imaging::Volume& image, const ShapeModel& model,
                              const segmentation::GivenPoints& points = {}, const FindOptions& options = {},
                              const Progress& progress = {});

}  // namespace glisson::shapes
