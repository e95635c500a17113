#pragma once
// Global non-rigid alignment (GNRA): all frames of a sequence are brought to one model at once, by landmarks that were
// followed through them. It follows Brown and Rusinkiewicz, "Global non-rigid alignment of 3-D scans", SIGGRAPH 2007,
// as the dissertation uses it (section 2.2.1: ALG, M and S).
//
// 1. Each frame gets a rigid motion, and each landmark one place in the model's space. The landmarks as moved then lie
//    nearest to their places, by iteratively reweighted least squares. A sighting that stays far from its landmark's
//    place counts less, and in the end nothing. Model space is that of a reference frame.
// 2. The warp S(.; t) of each frame leads its sightings to the landmarks' places: a smoothing thin-plate spline.
//    It is made stiffer until it folds nowhere that it was looked at: S is then one to one there.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "registration/thin_plate.h"

namespace glisson::registration {

// [landmark][frame]: where it was seen, in that frame's space; nothing where it was not.
using Sightings = std::vector<std::vector<std::optional<Eigen::Vector3d>>>;

struct GlobalAlignmentOptions {
  int iterations = 50;
  double smallest_step_mm = 1e-3;  // of any landmark's place, below which it has converged
  double outlier_mm = 5;           // a sighting this far from its landmark's place after step 1 counts a quarter; twice
                                   // as far and more, next to nothing (Geman and McClure's weights)
  double stiffness_mm = 2;         // of the warps, against noise of the sightings
  int maximum_centers = 400;       // of a warp
};

// How one frame comes to the model.
struct FrameAlignment {
  Eigen::Isometry3d rigid = Eigen::Isometry3d::Identity();  // step 1
  ThinPlateSpline warp;                                     // step 2: S(.; t), from the frame to the model
  double stiffness_mm = 0;                                  // that the warp needed, so as not to fold
};

struct GlobalAlignment {
  int reference = 0;  // the frame that holds most landmarks
  // Nothing for a frame with fewer than four good sightings, or all of them in one plane.
  std::vector<std::optional<FrameAlignment>> frames;
  std::vector<std::optional<Eigen::Vector3d>>
      landmarks_mm;          // in model space; nothing where fewer than two good sightings
  double before_rms_mm = 0;  // of the good sightings from their landmarks' mean, as the frames lie
  double rigid_rms_mm = 0;   // from the landmarks' places, after step 1
  double rms_mm = 0;         // after step 2
  int outliers = 0;          // sightings left out of step 2
  int iterations = 0;
  std::vector<std::string> notes;
};

// Fails with "alignment-too-few-frames" (fewer than two), "alignment-sizes" (landmarks with different numbers of
// frames) or "cancelled". Fails with "alignment-too-few-landmarks" where no two frames share four landmarks that do not
// lie in one plane.
Result<GlobalAlignment> align_globally(const Sightings& sightings, const GlobalAlignmentOptions& options = {},
                                       const Progress& progress = {});

// The model M is the reference frame's surface in model space. Each point is moved to the mean of where all warped
// frames have the surface near it. So the noise of a single frame goes. Near means along the lines to their nearest
// points, at most `reach_mm` away. `surfaces_mm` holds each frame's surface in its own space.
geometry::Surface merged_model(const std::vector<geometry::Surface>& surfaces, const GlobalAlignment& alignment,
                               double reach_mm = 3);

}  // namespace glisson::registration
