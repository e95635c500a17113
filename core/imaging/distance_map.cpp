// Exact distance transform by lower envelopes of parabolas.

#include "imaging/distance_map.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/result.h"

namespace glisson::imaging {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// One line of voxels along one axis, and what its transform needs.
struct Line {
  explicit Line(std::size_t length) : squared(length), nearest(length), owner(length), from(length + 1) {}
  std::vector<double> squared;         // in: from earlier axes
  std::vector<std::uint32_t> nearest;  // in: from earlier axes
  std::vector<std::size_t> owner;      // the parabolas of the lower envelope, by their place on the line
  std::vector<double> from;            // where each begins to be the lowest
};

// How many parabolas form the envelope of the line's values; none where all are infinite.
std::size_t find_envelope(Line& line, double spacing_mm) {
  std::size_t count = 0;
  const double scale = 1.0 / (spacing_mm * spacing_mm);
  for (std::size_t place = 0; place < line.squared.size(); ++place) {
    if (!std::isfinite(line.squared[place])) continue;
    const auto position = static_cast<double>(place);
    double start = -std::numeric_limits<double>::infinity();
    while (count > 0) {
      const auto rival = static_cast<double>(line.owner[count - 1]);
      start =
          ((line.squared[place] - line.squared[line.owner[count - 1]]) * scale + position * position - rival * rival) /
          (2.0 * (position - rival));
      if (start > line.from[count - 1]) break;
      --count;
      start = -std::numeric_limits<double>::infinity();
    }
    line.owner[count] = place;
    line.from[count] = start;
    ++count;
  }
  return count;
}

void transform_along(std::size_t axis, const Grid& grid, std::vector<float>& squared,
                     std::vector<std::uint32_t>* nearest) {
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(grid.size[0]), static_cast<std::size_t>(grid.size[1]),
                                        static_cast<std::size_t>(grid.size[2])};
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  const std::size_t u = axis == 0 ? 1 : 0;
  const std::size_t v = axis == 2 ? 1 : 2;
  const double spacing_mm = grid.spacing_mm[static_cast<Eigen::Index>(axis)];

  parallel_for(size[u] * size[v], 256, [&](std::size_t begin, std::size_t end) {
    Line line(size[axis]);
    for (std::size_t row = begin; row < end; ++row) {
      const std::size_t first = (row % size[u]) * stride[u] + (row / size[u]) * stride[v];
      for (std::size_t place = 0; place < size[axis]; ++place) {
        const std::size_t voxel = first + place * stride[axis];
        line.squared[place] = static_cast<double>(squared[voxel]);
        if (nearest != nullptr) line.nearest[place] = (*nearest)[voxel];
      }
      const std::size_t count = find_envelope(line, spacing_mm);
      if (count == 0) continue;
      std::size_t lowest = 0;
      for (std::size_t place = 0; place < size[axis]; ++place) {
        const auto position = static_cast<double>(place);
        while (lowest + 1 < count && line.from[lowest + 1] < position) ++lowest;
        const std::size_t owner = line.owner[lowest];
        const double along_mm = (position - static_cast<double>(owner)) * spacing_mm;
        const std::size_t voxel = first + place * stride[axis];
        squared[voxel] = static_cast<float>(line.squared[owner] + along_mm * along_mm);
        if (nearest != nullptr) (*nearest)[voxel] = line.nearest[owner];
      }
    }
  });
}

std::vector<float> zero_inside(const Mask& mask) {
  std::vector<float> squared(mask.values.size());
  for (std::size_t voxel = 0; voxel < squared.size(); ++voxel) squared[voxel] = mask.values[voxel] ? 0.0F : infinite;
  return squared;
}

}  // namespace

std::vector<float> squared_distances_mm2(const Mask& mask) {
  std::vector<float> squared = zero_inside(mask);
  for (std::size_t axis = 0; axis < 3; ++axis) transform_along(axis, mask.grid, squared, nullptr);
  return squared;
}

NearestVoxels nearest_voxels(const Mask& mask) {
  GLISSON_ASSERT(mask.values.size() < no_voxel);
  NearestVoxels found{zero_inside(mask), std::vector<std::uint32_t>(mask.values.size(), no_voxel)};
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (mask.values[voxel]) found.offset[voxel] = static_cast<std::uint32_t>(voxel);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    transform_along(axis, mask.grid, found.squared_distance_mm2, &found.offset);
  return found;
}

}  // namespace glisson::imaging
