#pragma once
// Where in an image a liver of the model's mean shape fits best, when nothing is known of it.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

struct PlacingOptions {
  double spacing_mm = 6;      // of the blocks that the image is judged in
  double step_mm = 12;        // of the first search; the second halves it twice about the best places
  double margin_mm = 7;       // nearer to the border nothing is judged: livers differ by more
  double shell_mm = 22;       // what lies around, up to here, should look otherwise
  double minimum_seen = 0.3;  // of the liver, inside the image
  double minimum_score = 0.3;
};

struct Placing {
  geometry::Surface surface;  // the mean, scaled and shifted to the patient's frame (LPS)
  double scale = 1;
  Eigen::Vector3d shift_mm{0, 0, 0};
  // The share of what lies inside that is of one brightness, less that of what lies around; at most 1. Less where the
  // image cuts the liver off, or it lies to the patient's left.
  double score = 0;
  double brightness = 0;  // median inside
};

// Robust statistics inside against outside, at every shift and at three sizes. Seeds (patient LPS, mm), where there are
// any, lie inside the liver placed (the first alone, where no place holds them all), and the brightness around them is
// the liver's. In HU only soft tissue counts.
// Fails with "shapes-no-liver-found" where the best place scores less than `minimum_score`; "cancelled".
Result<Placing> place_model(const imaging::Volume& image, const ShapeModel& model,
                            const std::vector<Eigen::Vector3d>& seeds_mm = {}, const PlacingOptions& options = {},
                            const Progress& progress = {});

// "shapes-no-liver-found", for that reason.
[[nodiscard]] Error no_liver_found(std::string sentence);

}  // namespace glisson::shapes
