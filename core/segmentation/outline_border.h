#pragma once
// The border of an organ's outline put where the image has it. For use within the room.

#include "imaging/image.h"

namespace glisson::segmentation {

struct BorderOptions {
  double band_mm = 5;     // the border moves at most so far
  double clear_mm = 2;    // voxels farther than this from the border are wholly inside or outside
  double local_mm = 5;    // standard deviation of the surroundings in which both sides' brightness is learnt
  double noise_mm = 1.5;  // standard deviation of the Gaussian that averages noise
  // Brighter and darker than the organ by more than this counts as so much: between lung or fat and the organ lies its
  // wall, which is not the organ.
  double clamp_sd = 5;
  // With fewer standard deviations between both sides the border stays, and nobody can be sure of it.
  double minimum_contrast_sd = 2;
};

struct RefinedBorder {
  imaging::Mask outline;
  double unsure_share = 0;  // of the border: where what lies beyond looks much like the organ
};

// The outline with its border half-way between the brightness of its own side and of the other, both learnt near by
// (local region-based energies: Lankton and Tannenbaum, IEEE Trans Image Process 17:2029, 2008, one step in a band).
// Where both sides are alike the border stays. `tissue_mean` and `tissue_sd` are the organ's brightness and the scatter
// of its single voxels. Deterministic.
[[nodiscard]] RefinedBorder with_border_refined(imaging::Mask outline, const imaging::Volume& image, double tissue_mean,
                                                double tissue_sd, const BorderOptions& options = {});

}  // namespace glisson::segmentation
