#pragma once
// How much the surroundings of each voxel look like a bright tube, by the Hessian of the image over several scales.
//
// A cylinder of radius r and contrast c, blurred with a Gaussian of standard deviation s, curves on its axis by
// lambda = -c r^2 / (2 s^4) exp(-r^2 / (2 s^2)) across. So s^2 |lambda| is largest at s = r / sqrt(2), where it is c /
// e.
//
// Source: Sato et al. 1998 (Med Image Anal 2:143); Frangi et al. 1998 (MICCAI, LNCS 1496:130) for what parts tubes from
// blobs and plates.

#include <vector>

#include "base/progress.h"
#include "imaging/image.h"

namespace glisson::segmentation {

struct Tubularity {
  std::vector<float> contrast;   // of each voxel the c above by its best scale, in the image's unit; 0: no tube. Of a
                                 // radius under two voxels about a fifth less: differences of voxels are no derivatives
  std::vector<float> radius_mm;  // r of that scale
  std::vector<float> to_noise;   // the largest of c over what noise gives at its scale
};

// `image` has one spacing along all axes (asserts) and no gaps (NaN). Only voxels of `within` (same grid: asserts) get
// an answer. `radii_mm` in ascending order. With sign -1 tubes are dark. What noise gives at a place is the
// size of the middle eigenvalue around it (20 mm), as of an image in which few voxels are tubes. Empty where `progress`
// is cancelled.
[[nodiscard]] Tubularity tubularity(const imaging::Image<float>& image, const imaging::Mask& within,
                                    const std::vector<double>& radii_mm, int sign, const Progress& progress = {});

}  // namespace glisson::segmentation
