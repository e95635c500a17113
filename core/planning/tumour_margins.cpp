#include "planning/internal/tumour_margins.h"

#include <algorithm>

#include "imaging/filters.h"
#include "planning/cut.h"
#include "segmentation/grid_part.h"

namespace glisson::planning {

TumourSurroundings surroundings_of(const std::string& name, const imaging::Mask& tumour, const Organ& organ,
                                   const std::vector<std::int32_t>& numbers) {
  TumourSurroundings found{name, {}, {}};
  imaging::Mask inside{organ.grid, std::vector<std::uint8_t>(organ.grid.voxels(), 0)};
  const std::vector<std::uint32_t> places = places_in(organ);
  sample(organ, tumour, 0, organ.runs.size(), [&](std::size_t voxel, std::uint8_t value) {
    if (value == 0) return;
    inside.values[places[voxel]] = 1;
    found.voxels.push_back(static_cast<std::uint32_t>(voxel));
  });
  if (found.voxels.empty()) return found;

  const double half_mm = 0.5 * organ.voxel_mm();
  const int rim = static_cast<int>(std::ceil((largest_margin_mm + half_mm) / organ.grid.spacing_mm.minCoeff()));
  const segmentation::Part part = segmentation::part_around(inside, rim);
  const std::vector<float> squared_mm2 = imaging::squared_distances_mm2(segmentation::cut_out(inside, part));

  // Sorted by counting: within a bin the order is that of the voxels.
  constexpr double bin_mm = 0.05;
  const auto bins = static_cast<std::size_t>(largest_margin_mm / bin_mm) + 1;
  std::vector<std::size_t> start(bins + 1, 0);
  std::vector<TumourSurroundings::Near> unsorted;
  std::size_t at = 0;
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      const std::size_t row = organ.grid.offset(part.first[0], j + part.first[1], k + part.first[2]);
      for (int i = 0; i < part.grid.size[0]; ++i, ++at) {
        const std::int32_t voxel = numbers[row + static_cast<std::size_t>(i)];
        if (voxel < 0 || squared_mm2[at] <= 0) continue;
        const float distance_mm = std::max(0.0F, std::sqrt(squared_mm2[at]) - static_cast<float>(half_mm));
        if (distance_mm > largest_margin_mm) continue;
        unsorted.push_back({static_cast<std::uint32_t>(voxel), distance_mm});
        ++start[static_cast<std::size_t>(distance_mm / bin_mm) + 1];
      }
    }
  }
  for (std::size_t b = 0; b < bins; ++b) start[b + 1] += start[b];
  found.around.resize(unsorted.size());
  for (const auto& near : unsorted) found.around[start[static_cast<std::size_t>(near.distance_mm / bin_mm)]++] = near;
  return found;
}

}  // namespace glisson::planning
