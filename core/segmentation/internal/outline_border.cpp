// The band about a border, cut where that costs least.

#include "segmentation/internal/outline_border.h"

#include <algorithm>
#include <cmath>

#include "imaging/filters.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/relaxed_cut.h"
#include "segmentation/signed_distance.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

using imaging::Mask;

// Those deep enough that no mixture of both sides is among them; all of them where none is.
Mask clearly_inside(const Mask& mask, const std::vector<float>& border_mm, double clear_mm) {
  Mask inside = mask;
  bool any = false;
  for (std::size_t voxel = 0; voxel < border_mm.size(); ++voxel) {
    inside.values[voxel] = border_mm[voxel] < static_cast<float>(-clear_mm) ? 1 : 0;
    any = any || inside.values[voxel] != 0;
  }
  return any ? inside : mask;
}

// 0 outside, 1 inside, and in the band between what the relaxed cut finds; empty where the band holds all of the mask.
imaging::Image<float> inside_level(const Mask& mask, const imaging::Image<float>& seen, const OrganLook& look,
                                   const BorderOptions::Round& round, const BorderOptions& options) {
  const std::vector<float> border_mm = signed_distances_mm(mask);
  const auto band_mm = static_cast<float>(round.band_mm);
  if (*std::min_element(border_mm.begin(), border_mm.end()) > -band_mm) return {};
  const TissueModel tissue = learn_tissue(seen, clearly_inside(mask, border_mm, options.likelihood.clear_mm),
                                          look.drift, look.drift_length_mm, look.smallest_sd);
  std::vector<float> cost = log_likelihood_ratio(seen, border_mm, tissue, round.band_mm, options.likelihood);
  std::vector<VoxelSide> sides(cost.size());
  const std::vector<float> odds =
      options.expected == nullptr ? std::vector<float>(cost.size()) : log_odds_outside(*options.expected, seen.grid);
  for (std::size_t voxel = 0; voxel < cost.size(); ++voxel) {
    cost[voxel] *= static_cast<float>(options.likelihood_per_mm);
    cost[voxel] += static_cast<float>(options.prior_per_mm) * std::max(odds[voxel], -most_for_inside);
    sides[voxel] = std::abs(border_mm[voxel]) <= band_mm ? VoxelSide::either
                   : border_mm[voxel] < 0                ? VoxelSide::inside
                                                         : VoxelSide::outside;
  }
  return {seen.grid, relaxed_cut(seen.grid, cost, sides)};
}

}  // namespace

Mask with_border_refined(Mask outline, const imaging::Volume& image, const OrganLook& look,
                         const BorderOptions& options) {
  double rim_mm = 0;
  for (const BorderOptions::Round& round : options.rounds) {
    rim_mm = std::max(rim_mm, round.band_mm + options.likelihood.far_mm);
  }
  const Part part = part_around(outline, static_cast<int>(std::ceil(rim_mm / image.grid.spacing_mm.minCoeff())));
  const imaging::Image<float> seen = cut_out<float>(image, part);
  Mask mask = cut_out(outline, part);
  for (const BorderOptions::Round& round : options.rounds) {
    const std::array<int, 3> block = blocks_of(part.grid, round.spacing_mm);
    const imaging::Image<float> level =
        inside_level(block_majority(mask, block), block_means(part.grid, seen.values, block), look, round, options);
    if (level.values.empty()) return outline;
    const std::vector<float> fine = interpolated(level, part.grid, block);
    for (std::size_t voxel = 0; voxel < fine.size(); ++voxel) mask.values[voxel] = fine[voxel] >= 0.5F ? 1 : 0;
  }
  put_back(imaging::fill_holes(mask), part, outline);
  return outline;
}

}  // namespace glisson::segmentation
