#include "planning/internal/organ.h"

#include "segmentation/grid_part.h"

namespace glisson::planning {

Organ organ_of(const imaging::Mask& mask) {
  const segmentation::Part part = segmentation::part_around(mask, 0);
  Organ organ;
  organ.grid = part.grid;
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      const std::uint8_t* row =
          mask.values.data() + mask.grid.offset(part.first[0], j + part.first[1], k + part.first[2]);
      for (int i = 0; i < part.grid.size[0]; ++i) {
        if (row[i] == 0) continue;
        if (i == 0 || row[i - 1] == 0) organ.runs.push_back({i, j, k, 0, organ.voxels});
        ++organ.runs.back().length;
        ++organ.voxels;
      }
    }
  }
  return organ;
}

std::vector<std::int32_t> numbers_in(const Organ& organ) {
  std::vector<std::int32_t> numbers(organ.grid.voxels(), -1);
  for (const Run& run : organ.runs) {
    std::int32_t* row = numbers.data() + organ.grid.offset(run.i, run.j, run.k);
    for (int n = 0; n < run.length; ++n) row[n] = static_cast<std::int32_t>(run.first) + n;
  }
  return numbers;
}

std::vector<std::uint32_t> places_in(const Organ& organ) {
  std::vector<std::uint32_t> places(organ.voxels);
  for (const Run& run : organ.runs) {
    const auto start = static_cast<std::uint32_t>(organ.grid.offset(run.i, run.j, run.k));
    for (int n = 0; n < run.length; ++n) {
      places[run.first + static_cast<std::size_t>(n)] = start + static_cast<std::uint32_t>(n);
    }
  }
  return places;
}

}  // namespace glisson::planning
