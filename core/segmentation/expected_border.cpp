#include "segmentation/expected_border.h"

#include <algorithm>

#include "segmentation/resample.h"

namespace glisson::segmentation {

double log_odds_at(double deviations) {
  const double z = std::clamp(deviations, -farthest_sd, farthest_sd);
  return 1.5976 * z + 0.07056 * z * z * z;
}

std::vector<float> log_odds_outside(const ExpectedBorder& expected, const imaging::Grid& grid) {
  std::vector<float> odds = resample(expected.distance_mm, grid).values;
  const imaging::Image<float> sd_mm = resample(expected.sd_mm, grid);
  for (std::size_t voxel = 0; voxel < odds.size(); ++voxel) {
    odds[voxel] = static_cast<float>(log_odds_at(static_cast<double>(odds[voxel] / sd_mm.values[voxel])));
  }
  return odds;
}

}  // namespace glisson::segmentation
