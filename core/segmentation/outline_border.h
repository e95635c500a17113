#pragma once
// The border of an organ's outline put where the image has it. For use within the room.

#include "imaging/image.h"
#include "segmentation/likelihood_ratio.h"
#include "segmentation/tissue_model.h"

namespace glisson::segmentation {

struct BorderOptions {
  double spacing_mm = 1.25;  // of the grid that the border is sought on, about; voxels larger than this stay
  double band_mm = 5;        // the border moves at most so far in a round
  int rounds = 2;            // both sides are learnt anew from where the first one put it
  // How much a voxel's likelihood counts against the border's area, in 1/mm. Where both sides are 20 times as likely on
  // their own as on the other, bays and bumps of less than about 3 mm are smoothed away.
  double likelihood_per_mm = 0.2;
  LikelihoodOptions likelihood;
};

struct OrganLook {
  TissueModel::Drift drift = TissueModel::Drift::additive;
  double drift_length_mm = 30;
  double smallest_sd = 0;  // what a noise-free image is taken to have, as in learn_tissue()
};

// The outline with its border where it divides best what looks like the organ from what looks like its neighbours, both
// learnt near by, and is no longer than that asks for: the relaxed cut (relaxed_cut.h) of the likelihood ratio
// (likelihood_ratio.h) in a band about the border. An outline without a voxel deeper than the band is left as it is: a
// mouse's liver is smaller than the bumps that are smoothed away. Deterministic.
[[nodiscard]] imaging::Mask with_border_refined(imaging::Mask outline, const imaging::Volume& image,
                                                const OrganLook& look, const BorderOptions& options = {});

}  // namespace glisson::segmentation
