// Flood fill in slices.

#include "segmentation/internal/slice_holes.h"

#include <array>
#include <numbers>

#include "base/parallel.h"

namespace glisson::segmentation {
namespace {

// The slices across one axis: how far apart voxels lie in memory along the slice's two axes and across it.
struct Slices {
  std::array<std::size_t, 3> size, stride;  // u, v, across
  std::size_t largest_hole;                 // in voxels
};

Slices slices_across(std::size_t axis, const imaging::Grid& grid, double radius_mm) {
  const std::array<std::size_t, 3> order{(axis + 1) % 3, (axis + 2) % 3, axis};
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(grid.size[0]),
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
  Slices slices{};
  for (std::size_t n = 0; n < 3; ++n) {
    slices.size[n] = static_cast<std::size_t>(grid.size[order[n]]);
    slices.stride[n] = stride[order[n]];
  }
  const double pixel_mm2 =
      grid.spacing_mm[static_cast<Eigen::Index>(order[0])] * grid.spacing_mm[static_cast<Eigen::Index>(order[1])];
  slices.largest_hole = static_cast<std::size_t>(std::numbers::pi * radius_mm * radius_mm / pixel_mm2);
  return slices;
}

void fill_slice(const Slices& slices, std::size_t slice, const imaging::Mask& mask, std::vector<std::uint8_t>& filled) {
  const std::size_t width = slices.size[0], height = slices.size[1];
  const auto voxel_of = [&](std::size_t place) {
    return (place % width) * slices.stride[0] + (place / width) * slices.stride[1] + slice * slices.stride[2];
  };
  std::vector<bool> seen(width * height, false);
  std::vector<std::size_t> hole;
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start] || mask.values[voxel_of(start)] != 0) continue;
    hole.assign(1, start);
    seen[start] = true;
    bool reaches_edge = false;
    const auto visit = [&](std::size_t place) {
      if (seen[place] || mask.values[voxel_of(place)] != 0) return;
      seen[place] = true;
      hole.push_back(place);
    };
    for (std::size_t n = 0; n < hole.size(); ++n) {
      const std::size_t u = hole[n] % width, v = hole[n] / width;
      if (u == 0 || v == 0 || u + 1 == width || v + 1 == height) reaches_edge = true;
      if (u > 0) visit(hole[n] - 1);
      if (u + 1 < width) visit(hole[n] + 1);
      if (v > 0) visit(hole[n] - width);
      if (v + 1 < height) visit(hole[n] + width);
    }
    if (reaches_edge || hole.size() > slices.largest_hole) continue;
    for (const std::size_t place : hole) filled[voxel_of(place)] = 1;
  }
}

}  // namespace

imaging::Mask with_slice_holes_filled(const imaging::Mask& mask, double radius_mm) {
  imaging::Mask filled = mask;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Slices slices = slices_across(axis, mask.grid, radius_mm);
    parallel_for(slices.size[2], 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slice = begin; slice < end; ++slice) fill_slice(slices, slice, mask, filled.values);
    });
  }
  return filled;
}

}  // namespace glisson::segmentation
