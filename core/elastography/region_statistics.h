#pragma once
// What a map holds in a region.

#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::elastography {

struct RegionStatistics {
  std::size_t voxels = 0;           // that hold a finite value
  std::size_t voxels_left_out = 0;  // not finite
  double mean = 0, sd = 0;          // in the map's unit; sd with n - 1
  double min = 0, percentile_5 = 0, percentile_25 = 0, median = 0, percentile_75 = 0, percentile_95 = 0, max = 0;
};

// Over the voxels of the mask, which lies on the map's grid. Fails with region-grids-differ, region-empty.
Result<RegionStatistics> region_statistics(const imaging::Volume& map, const imaging::Mask& region);

// Of any values. Fails with region-empty.
Result<RegionStatistics> statistics_of(std::vector<double> values);

}  // namespace glisson::elastography
