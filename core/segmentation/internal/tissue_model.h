#pragma once
// What the liver looks like in an image: how bright where, how much single voxels scatter, and which voxels look so.
//

#include <string>
#include <vector>

#include "imaging/image.h"
#include "segmentation/grow.h"

namespace glisson::segmentation {

// The value that most of the values lie around. It is sought in the half of them that lie closest together, and again
// in that half (half-sample mode, Robertson and Cryer 1974). Some of a ball's voxels being vessel or fat does not move
// it.
[[nodiscard]] double mode_of(std::vector<float> values);

// `image` smoothed with weights that leave out what is not finite and what lies beyond the image; NaN where nothing is
// near.
[[nodiscard]] std::vector<float> smoothed(const imaging::Image<float>& image, double sd_mm);

struct TissueModel {
  // Brightness scales with the coils' sensitivity in MR, and has an offset in CT.
  enum class Drift { proportional, additive } drift = Drift::additive;
  std::vector<float> expected;  // brightness, one a voxel
  double mean = 0;              // over the tissue seen
  double sd = 0;                // of single voxels

  // How far a voxel is off, in the brightness of the tissue's mean.
  [[nodiscard]] float residual(float value, std::size_t voxel) const;
};

// Between the lowest and the highest fiftieth of the finite values: metal and noise do not stretch it.
struct GreyContrast {
  double low = 0, high = 0;
  bool has_any = false;  // not all values are the same
};
[[nodiscard]] GreyContrast contrast_of_values(const std::vector<float>& values);

// What is to be expected of a tissue of this brightness before it is looked at.
struct TissueKind {
  TissueModel::Drift drift;
  double smallest_sd;  // of block means; less is not believed
};
[[nodiscard]] TissueKind tissue_kind(const std::string& unit, const GreyContrast& contrast, double brightness);

// Learns from the voxels that are known to be tissue. `smallest_sd` is what a noise-free image is taken to have.
[[nodiscard]] TissueModel learn_tissue(const imaging::Image<float>& image, const imaging::Mask& known,
                                       TissueModel::Drift drift, double drift_length_mm, double smallest_sd);

// The voxels whose surroundings look like the tissue (see GrowOptions).
[[nodiscard]] imaging::Mask looks_like(const TissueModel& tissue, const imaging::Image<float>& image,
                                       const GrowOptions& options);

}  // namespace glisson::segmentation
