#pragma once
// A part that hangs on a structure by a neck, as a leak into heart or stomach does, taken off with one click.

#include <Eigen/Core>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

struct NeckOptions {
  // What joins two parts is a neck where it is at most this share as thick as the part that is taken off.
  double maximum_share = 0.8;
};

// Takes away the part of the mask that a place (patient LPS, mm) lies in. It is all that a flood from its middle
// reaches before one from the middle of the whole does. Deep voxels are flooded first, so that both meet where the mask
// is narrowest (watershed by flooding: Meyer, Signal Processing 38:113, 1994). A place within a separate piece takes
// that piece. The middle is the deepest voxel, depth the distance to the nearest voxel outside.
//
// Fails with "edit-no-piece-there" where the mask does not hold the place. Fails with "edit-no-neck" where the place
// lies in the main part, or nothing narrower joins the two. Deterministic.
Result<imaging::Mask> without_part_at(imaging::Mask mask, const Eigen::Vector3d& place_mm,
                                      const NeckOptions& options = {});

}  // namespace glisson::segmentation
