#pragma once
// Where the border of an organ is expected before its image is looked at, and how surely.

#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// From the expected border: what lies beyond is decided by the shape alone.
constexpr double farthest_sd = 3;

struct ExpectedBorder {
  imaging::Image<float> distance_mm;  // from the expected border, negative inside; its grid may be coarse
  imaging::Image<float> sd_mm;        // of where the border is there; same grid, above 0
};

// At most this counts for inside. So what looks clearly like something else (a likelihood of 3) is left out of an organ
// that reaches less far than others; what looks like the organ is still kept out of where it never reaches.
constexpr float most_for_inside = 2.5F;

// The natural logarithm of how likely each voxel of the grid is to lie outside over how likely inside. The border lies
// where it is expected but for a normal deviation. So it is log(P / (1 - P)) with P the normal distribution of distance
// over deviation, here 1.5976 z + 0.07056 z^3 (off by less than 0.0002 in P; Bowling et al., J Ind Eng Manag 2:114,
// 2009). Beyond three deviations it stays.
[[nodiscard]] double log_odds_at(double deviations);
[[nodiscard]] std::vector<float> log_odds_outside(const ExpectedBorder& expected, const imaging::Grid& grid);

}  // namespace glisson::segmentation
