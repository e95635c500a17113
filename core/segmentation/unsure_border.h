#pragma once
// Where an outline's border cannot be seen: what lies on both sides of it looks alike.

#include <Eigen/Core>
#include <vector>

#include "imaging/image.h"
#include "segmentation/expected_border.h"

namespace glisson::segmentation {

struct UnsureBorderOptions {
  double spacing_mm = 2.5;  // of the grid that is looked at, about; voxels larger than this stay
  double clear_mm = 2;      // voxels farther than this from the border are wholly inside or outside
  double local_mm = 5;      // standard deviation of the surroundings in which both sides' brightness is learnt
  // Brighter and darker than the organ by more than this counts as so much.
  double clamp_sd = 5;
  double minimum_contrast_sd = 2;  // between both sides: with less nobody can be sure of the border
  // Nor of one that lies this many deviations or more from where a shape expects it.
  const ExpectedBorder* expected = nullptr;
  double surprising_sd = 2;
  // Places that are told apart: the most, how far from each other, and how much of the border around each is unsure.
  int most_places = 3;
  double apart_mm = 40;
  double minimum_share = 0.02;
};

struct UnsureBorder {
  double share = 0;  // of the border: where both sides look alike, or a shape expects it elsewhere
  // The middles of the largest such places (patient LPS, mm), the largest first, on the border.
  std::vector<Eigen::Vector3d> places_mm;
};

// `tissue_mean` and `tissue_sd` are the organ's brightness and the scatter of its single voxels, in the image's unit.
[[nodiscard]] UnsureBorder unsure_border(const imaging::Mask& outline, const imaging::Volume& image, double tissue_mean,
                                         double tissue_sd, const UnsureBorderOptions& options = {});

// The same of any outline, a hand's or another program's: the organ's look is learnt from what it holds. Nothing is
// unsure of an outline that holds nothing (share 0). The image lies on the outline's grid (asserts).
[[nodiscard]] UnsureBorder unsure_border(const imaging::Mask& outline, const imaging::Volume& image,
                                         const UnsureBorderOptions& options = {});

}  // namespace glisson::segmentation
