#pragma once
// The border of an organ's outline put where the image has it.

#include <vector>

#include "imaging/image.h"
#include "segmentation/expected_border.h"
#include "segmentation/internal/likelihood_ratio.h"
#include "segmentation/internal/tissue_model.h"

namespace glisson::segmentation {

struct BorderOptions {
  // The border is sought on a grid of about this spacing, voxels larger than that staying, and moves at most so far.
  // Both sides are learnt anew in each round; the first may be coarse, the second needs to look only near by.
  struct Round {
    double spacing_mm, band_mm;
  };
  std::vector<Round> rounds{{2.5, 5}, {1.25, 3}};
  // How much a voxel's likelihood counts against the border's area, in 1/mm. Bays and bumps of less than about 3 mm are
  // smoothed away. That holds where both sides are 20 times as likely on their own as on the other.
  double likelihood_per_mm = 0.2;
  LikelihoodOptions likelihood;
  // Where a shape says that the border lies, and how much its log-odds count; none where there is no shape.
  const ExpectedBorder* expected = nullptr;
  double prior_per_mm = 0.2;
};

struct OrganLook {
  TissueModel::Drift drift = TissueModel::Drift::additive;
  double drift_length_mm = 30;
  double smallest_sd = 0;  // what a noise-free image is taken to have, as in learn_tissue()
};

// The outline with its border put where it divides best what looks like the organ from what looks like its neighbours.
// Both are learnt near by, and the border is no longer than that asks for. It is the relaxed cut (relaxed_cut.h) of the
// likelihood ratio (likelihood_ratio.h), in a band about the border. An outline without a voxel deeper than a round's
// band is left as it is. A mouse's liver is smaller than the bumps that are smoothed away. Deterministic.
[[nodiscard]] imaging::Mask with_border_refined(imaging::Mask outline, const imaging::Volume& image,
                                                const OrganLook& look, const BorderOptions& options = {});

}  // namespace glisson::segmentation
