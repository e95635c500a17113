#pragma once
// How much more a voxel looks like what lies beyond a border than like the organ within it.

#include <vector>

#include "imaging/image.h"
#include "segmentation/internal/tissue_model.h"

namespace glisson::segmentation {

struct LikelihoodOptions {
  double clear_mm = 2;  // nearer to the border a voxel may be a mixture of both sides: nothing is learnt from it
  double far_mm = 20;   // from the border: what lies farther off is no neighbour
  // Both sides' values are counted in Gaussian surroundings of this standard deviation: the organ has many neighbours,
  // each of its own brightness.
  double local_mm = 8;
  // The histograms of all of a side count as this share of the surroundings, so that a side with few voxels is known.
  double everywhere_share = 0.05;
  int bins = 32;
  double range_sd = 6;  // on either side of the organ's brightness; beyond it values fall into the last bin
  // What was seen nowhere is more likely outside, where anything may lie.
  double unseen_outside = 0.01, unseen_inside = 0.003;
  double most = 3;  // of the logarithm: one voxel does not outvote its surroundings
};

// The natural logarithm of how likely each voxel's value is beyond the border over how likely it is within. Both come
// by histograms learnt near by. It is 0 where the value is not finite, and farther than `band_mm` from the border.
// `border_mm` is the signed distance from the border, one a voxel, negative inside. `tissue` is the organ on the
// image's grid: its drift is taken off before anything is counted.
[[nodiscard]] std::vector<float> log_likelihood_ratio(const imaging::Image<float>& image,
                                                      const std::vector<float>& border_mm, const TissueModel& tissue,
                                                      double band_mm, const LikelihoodOptions& options = {});

}  // namespace glisson::segmentation
