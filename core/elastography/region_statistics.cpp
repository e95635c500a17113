// Statistics of a map in a region.

#include "elastography/region_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson::elastography {
namespace {

// Linear between the values on either side, as most programs do it (type 7 of Hyndman and Fan 1996).
double percentile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Result<RegionStatistics> region_statistics(const imaging::Volume& map, const imaging::Mask& region) {
  if (!imaging::same_grid(map.grid, region.grid)) {
    return failure("region-grids-differ", GLISSON_TEXT("The region lies on another voxel grid than the map."));
  }
  std::vector<double> values;
  for (std::size_t voxel = 0; voxel < map.values.size(); ++voxel) {
    if (region.values[voxel] != 0) values.push_back(static_cast<double>(map.values[voxel]));
  }
  return statistics_of(std::move(values));
}

Result<RegionStatistics> statistics_of(std::vector<double> values) {
  RegionStatistics found;
  const auto finite_end =
      std::partition(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  found.voxels_left_out = static_cast<std::size_t>(values.end() - finite_end);
  values.erase(finite_end, values.end());
  if (values.empty()) return failure("region-empty", GLISSON_TEXT("The region holds no value."));

  std::sort(values.begin(), values.end());
  found.voxels = values.size();
  const auto count = static_cast<double>(values.size());
  found.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - found.mean) * (value - found.mean);
  found.sd = values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0.0;
  found.min = values.front();
  found.percentile_5 = percentile(values, 0.05);
  found.percentile_25 = percentile(values, 0.25);
  found.median = percentile(values, 0.5);
  found.percentile_75 = percentile(values, 0.75);
  found.percentile_95 = percentile(values, 0.95);
  found.max = values.back();
  return found;
}

}  // namespace glisson::elastography
