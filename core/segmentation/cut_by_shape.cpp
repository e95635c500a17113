// Costs of brightness and of shape added up, and cut where their sum and the border's area are least.

#include "segmentation/cut_by_shape.h"

#include <algorithm>
#include <cmath>

#include "base/upper_median.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/growth_doubts.h"
#include "segmentation/internal/half_step.h"
#include "segmentation/internal/likelihood_ratio.h"
#include "segmentation/internal/outline_border.h"
#include "segmentation/internal/relaxed_cut.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/resample.h"
#include "segmentation/signed_distance.h"
#include "segmentation/structures.h"
#include "segmentation/unsure_border.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

// Before anything is known of the surroundings: a normal organ among neighbours of any brightness. The constant is the
// logarithm of their spread, some ten times the organ's, over the normal density's factor.
std::vector<float> ratio_of_brightness(const imaging::Volume& image, const OrganBrightness& organ);
// By histograms of both sides of the start's border.
std::vector<float> ratio_about(const imaging::Volume& image, const Mask& start, const OrganBrightness& organ,
                               double reach_mm);
// The pieces that hold a seed; without one the largest.
Mask main_piece(Mask mask, const std::vector<Vector3d>& seeds_mm);
// The expected border moved outwards, so that it has balls around the seeds inside.
ExpectedBorder around_seeds(ExpectedBorder expected, const std::vector<Vector3d>& seeds_mm, double radius_mm);

OrganLook look_of(const imaging::Volume& image, double brightness) {
  const TissueKind kind = tissue_kind(image.unit, contrast_of_values(image.values), brightness);
  return {kind.drift, GrowOptions{}.drift_length_mm, kind.smallest_sd};
}

}  // namespace

Result<OrganBrightness> brightness_of(const imaging::Volume& image, const ExpectedBorder& expected,
                                      const std::vector<Vector3d>& seeds_mm) {
  constexpr float surely_inside = -3;  // in log-odds
  std::vector<float> values, held;
  for (const Vector3d& seed_mm : seeds_mm) {
    for (const std::size_t voxel : voxels_around(seed_mm, GrowOptions{}.sample_radius_mm, image.grid)) {
      if (std::isfinite(image.values[voxel])) values.push_back(image.values[voxel]);
    }
  }
  const std::vector<float> odds = log_odds_outside(expected, image.grid);
  for (std::size_t voxel = 0; voxel < odds.size(); ++voxel) {
    if (odds[voxel] < surely_inside && std::isfinite(image.values[voxel])) held.push_back(image.values[voxel]);
  }
  if (seeds_mm.empty()) values = held;
  if (values.empty()) {
    return failure("grow-seed-on-nothing", GLISSON_TEXT("There is no image value where the liver is looked for."));
  }
  OrganBrightness organ;
  organ.mean = mode_of(values);
  const auto scatter = [&organ](std::vector<float> of) {
    for (float& value : of) value = std::abs(value - static_cast<float>(organ.mean));
    return of.empty() ? 0.0 : 1.4826 * static_cast<double>(upper_median(std::move(of)));
  };
  // A shape that is placed badly holds much else.
  constexpr double most_times = 3;
  const double near_seeds = std::max(scatter(values), 0.5 * look_of(image, organ.mean).smallest_sd);
  organ.sd = std::clamp(scatter(held), near_seeds, most_times * near_seeds);
  return organ;
}

imaging::Image<float> outside_ratio(const imaging::Volume& image, const OrganBrightness& organ, const Mask* outline,
                                    const ShapeCutOptions& options) {
  return {image.grid, outline == nullptr ? ratio_of_brightness(image, organ)
                                         : ratio_about(image, *outline, organ, options.reach_mm)};
}

Mask cut_by_shape(const imaging::Image<float>& outside, const ExpectedBorder& expected,
                  const std::vector<Vector3d>& seeds_mm, const ShapeCutOptions& options) {
  const ExpectedBorder told = around_seeds(expected, seeds_mm, options.seed_radius_mm);
  const std::vector<float> odds = log_odds_outside(told, outside.grid);
  const std::vector<float> depth = resample(told.distance_mm, outside.grid).values;
  const auto surely = static_cast<float>(log_odds_at(farthest_sd)) - 1e-3F;
  std::vector<float> cost(odds.size());
  std::vector<VoxelSide> sides(odds.size());
  for (std::size_t voxel = 0; voxel < odds.size(); ++voxel) {
    cost[voxel] = static_cast<float>(options.likelihood_per_mm) * outside.values[voxel] +
                  static_cast<float>(options.prior_per_mm) * std::max(odds[voxel], -most_for_inside);
    sides[voxel] = odds[voxel] > surely                          ? VoxelSide::outside
                   : odds[voxel] < -surely && depth[voxel] < -25 ? VoxelSide::inside
                                                                 : VoxelSide::either;
  }
  const std::vector<float> inside = relaxed_cut(outside.grid, cost, sides);
  Mask mask{outside.grid, std::vector<std::uint8_t>(odds.size())};
  for (std::size_t voxel = 0; voxel < odds.size(); ++voxel) mask.values[voxel] = inside[voxel] >= 0.5F ? 1 : 0;
  return main_piece(std::move(mask), seeds_mm);
}

GrowResult finished_by_shape(const Mask& coarse, const imaging::Volume& image, const ExpectedBorder& expected,
                             const OrganBrightness& organ, const std::vector<Vector3d>& seeds_mm,
                             const ShapeCutOptions& options) {
  const Part few = part_around(coarse, 1);
  std::vector<Vector3d> corners;
  for (int c = 0; c < 8; ++c) {
    corners.push_back(few.grid.position_mm((c & 1) * (few.grid.size[0] - 1), ((c >> 1) & 1) * (few.grid.size[1] - 1),
                                           (c >> 2) * (few.grid.size[2] - 1)));
  }
  const Part part = part_around(corners, coarse.grid.spacing_mm.maxCoeff(), image.grid);
  const imaging::Image<float> level{coarse.grid, {coarse.values.begin(), coarse.values.end()}};
  const imaging::Image<float> fine = resample(level, part.grid);
  Mask piece{part.grid, std::vector<std::uint8_t>(fine.values.size())};
  for (std::size_t voxel = 0; voxel < fine.values.size(); ++voxel) piece.values[voxel] = fine.values[voxel] >= 0.5F;

  const ExpectedBorder told = around_seeds(expected, seeds_mm, options.seed_radius_mm);
  BorderOptions border;
  border.expected = &told;
  border.prior_per_mm = options.prior_per_mm;
  border.likelihood.local_mm = 12;
  GrowResult result;
  result.mask = {image.grid, std::vector<std::uint8_t>(image.grid.voxels())};
  put_back(piece, part, result.mask);
  result.mask = with_border_refined(std::move(result.mask), image, look_of(image, organ.mean), border);
  result.mask = main_piece(at_half_step(std::move(result.mask), image, organ.sd), seeds_mm);
  result.volume_ml = volume_ml(result.mask);
  result.tissue_mean = organ.mean;
  result.tissue_sd = organ.sd;
  UnsureBorderOptions looking;
  looking.expected = &told;
  const UnsureBorder unsure = unsure_border(result.mask, image, organ.mean, organ.sd, looking);
  result.unsure_border = unsure.share;
  result.unsure_places_mm = unsure.places_mm;
  result.doubts = doubts_about(result, {organ.mean}, {});
  return result;
}

namespace {

std::vector<float> ratio_of_brightness(const imaging::Volume& image, const OrganBrightness& organ) {
  constexpr float spread_of_others = 1.5, most = 3;
  std::vector<float> ratio(image.values.size());
  for (std::size_t voxel = 0; voxel < ratio.size(); ++voxel) {
    const float off = (image.values[voxel] - static_cast<float>(organ.mean)) / static_cast<float>(organ.sd);
    if (std::isfinite(off)) ratio[voxel] = std::clamp(0.5F * off * off - spread_of_others, -most, most);
  }
  return ratio;
}

std::vector<float> ratio_about(const imaging::Volume& image, const Mask& start, const OrganBrightness& organ,
                               double reach_mm) {
  const std::vector<float> border_mm = signed_distances_mm(start);
  Mask inside = start;
  bool any = false;
  const LikelihoodOptions options{.clear_mm = 3, .far_mm = reach_mm, .local_mm = 12};
  for (std::size_t voxel = 0; voxel < border_mm.size(); ++voxel) {
    inside.values[voxel] = border_mm[voxel] < static_cast<float>(-options.clear_mm) ? 1 : 0;
    any = any || (inside.values[voxel] != 0 && std::isfinite(image.values[voxel]));
  }
  if (!any) return ratio_of_brightness(image, organ);
  const OrganLook look = look_of(image, organ.mean);
  const TissueModel tissue = learn_tissue(image, inside, look.drift, look.drift_length_mm, look.smallest_sd);
  return log_likelihood_ratio(image, border_mm, tissue, reach_mm, options);
}

Mask main_piece(Mask mask, const std::vector<Vector3d>& seeds_mm) {
  // A rim of what lies outside shows which holes are closed.
  const Part part = part_around(mask, 1);
  Mask held = cut_out(mask, part);
  const imaging::ConnectedVoxels pieces = imaging::connected_voxels(held, imaging::Neighbours::faces);
  std::vector<std::uint8_t> kept(pieces.sizes.size());
  const std::uint32_t largest = pieces.largest();
  if (largest == 0) return mask;
  kept[largest] = 1;
  for (const Vector3d& seed_mm : seeds_mm) {
    const auto nearest = nearest_voxel(seed_mm, GrowOptions{}.sample_radius_mm, held);
    if (nearest) kept[pieces.piece[*nearest]] = 1;
  }
  for (std::size_t voxel = 0; voxel < held.values.size(); ++voxel) held.values[voxel] = kept[pieces.piece[voxel]];
  put_back(imaging::fill_holes(held), part, mask);
  return mask;
}

ExpectedBorder around_seeds(ExpectedBorder expected, const std::vector<Vector3d>& seeds_mm, double radius_mm) {
  const imaging::Grid& grid = expected.distance_mm.grid;
  for (const Vector3d& seed_mm : seeds_mm) {
    // Beyond twice the radius nothing changes but where the border lies farther off still.
    for (const std::size_t voxel : voxels_around(seed_mm, 2 * radius_mm, grid)) {
      const Eigen::Vector3i at = index_of(voxel, grid);
      const double ball_mm = (grid.position_mm(at.x(), at.y(), at.z()) - seed_mm).norm() - radius_mm;
      float& distance_mm = expected.distance_mm.values[voxel];
      distance_mm = std::min(distance_mm, static_cast<float>(ball_mm));
    }
  }
  return expected;
}

}  // namespace
}  // namespace glisson::segmentation
