// Growing in rounds: what looks like the tissue, what of it hangs together, and what the tissue looks like then.

#include "segmentation/grow.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/growth_doubts.h"
#include "segmentation/internal/outline_border.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/slice_holes.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/structures.h"
#include "segmentation/unsure_border.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

using WorkingImage = imaging::Image<float>;  // block means of the image

constexpr int maximum_rounds = 30;  // the region is usually the same after six to nine; a strong drift takes longer

constexpr double settled_fraction = 1e-3;  // rounds that turn fewer of the region's voxels may go on in a circle

Result<void> check(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm, const GrowOptions& options);

// What is known of one seed.
struct Seed {
  Vector3d position_mm;
  std::vector<std::size_t> voxels;  // around it, of its own brightness
  double brightness;
  double sd;  // of single voxels
};
Result<std::vector<Seed>> look_around_seeds(const WorkingImage& image, const std::vector<Vector3d>& seeds_mm,
                                            const GrowOptions& options);
Mask mask_of_seeds(const std::vector<Seed>& seeds, const Grid& grid);

// The part of the tissue that hangs together with the seeds and is thicker than a neck, its tips given back.
struct Region {
  Mask core;  // centres of balls of the neck's radius that fit
  Mask whole;
  std::vector<bool> holds_seed;  // for each seed: whether there was any
};
Region region_of(const Mask& tissue, const std::vector<Seed>& seeds, const GrowOptions& options);

// What a growth comes to with these options.
struct Settled {
  Region region;
  TissueModel tissue;
  int rounds = 0;
};
Result<Settled> settled_region(const WorkingImage& working, const std::vector<Seed>& seeds, TissueModel::Drift drift,
                               double smallest_sd, const GrowOptions& options, const Progress& progress);

// The tolerance, in times of the option's, at which the growth comes to much more and still wider to nearly the same:
// something with a border of its own, of which the narrow growth is a part in another light (between the arms a CT is
// darker). So are extremal regions found stable (Matas et al., Image Vision Comput 22:761, 2004). Nothing where it is
// not so: a leak goes on growing. Looked for in coarse voxels, which cost little.
std::optional<double> stable_tolerance(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm,
                                       double narrow_ml, TissueModel::Drift drift, double smallest_sd,
                                       const GrowOptions& options, const Progress& progress);
GrowOptions at_tolerance(GrowOptions options, double times);
constexpr double rather_unsure_border = 0.2;  // of its border, where it is asked whether it is a part only

Mask finished(const Region& region, const Grid& grid, const std::array<int, 3>& block, const GrowOptions& options);
Mask without_crumbs(Mask mask);

double changed_fraction(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after);

}  // namespace

Result<GrowResult> grow_from_seeds(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm,
                                   const GrowOptions& options, const Progress& progress) {
  if (Result<void> checked = check(image, seeds_mm, options); !checked) return failure(checked.error());
  const std::array<int, 3> block = blocks_of(image.grid, options.working_spacing_mm);
  const WorkingImage working = block_means(image.grid, image.values, block);
  const GreyContrast contrast = contrast_of_values(working.values);
  if (!contrast.has_any) {
    return failure("grow-constant-image",
                   GLISSON_TEXT("Every voxel of the image has the same value: there is nothing to grow in."));
  }

  Result<std::vector<Seed>> seeds = look_around_seeds(working, seeds_mm, options);
  if (!seeds) return failure(seeds.error());
  const double darkest = std::min_element(seeds->begin(), seeds->end(), [](const Seed& a, const Seed& b) {
                           return a.brightness < b.brightness;
                         })->brightness;
  const TissueKind kind = tissue_kind(image.unit, contrast, darkest);

  Result<Settled> settled = settled_region(working, *seeds, kind.drift, kind.smallest_sd, options, progress);
  if (!settled) return failure(settled.error());

  if (progress.cancelled()) return cancelled();
  progress.report(static_cast<double>(maximum_rounds + 1) / (maximum_rounds + 2),
                  GLISSON_TEXT("Smoothing the outline"));
  std::vector<double> brightness;
  for (const Seed& seed : *seeds) brightness.push_back(seed.brightness);
  const auto told = [&](Mask outline, const Settled& grown) {
    GrowResult result;
    result.rounds = grown.rounds;
    result.mask = std::move(outline);
    const UnsureBorder unsure = unsure_border(result.mask, image, grown.tissue.mean, grown.tissue.sd);
    result.unsure_border = unsure.share;
    result.unsure_places_mm = unsure.places_mm;
    result.volume_ml = volume_ml(result.mask);
    result.tissue_mean = grown.tissue.mean;
    result.tissue_sd = grown.tissue.sd;
    result.doubts = doubts_about(result, brightness, grown.region.holds_seed);
    return result;
  };
  GrowResult result = told(finished(settled->region, image.grid, block, options), *settled);
  if (result.unsure_border > rather_unsure_border) {
    const auto times = stable_tolerance(image, seeds_mm, volume_ml(settled->region.whole), kind.drift, kind.smallest_sd,
                                        options, progress);
    if (progress.cancelled()) return cancelled();
    if (times) {
      auto wider =
          settled_region(working, *seeds, kind.drift, kind.smallest_sd, at_tolerance(options, *times), progress);
      if (progress.cancelled()) return cancelled();
      if (wider) {
        GrowResult other = told(finished(wider->region, image.grid, block, options), *wider);
        // The air around a body has a border of its own too.
        if (other.unsure_border < result.unsure_border && !other.probably_leaked()) {
          result = std::move(other);
          settled = std::move(wider);
        }
      }
    }
  }
  if (progress.cancelled()) return cancelled();
  const OrganLook look{kind.drift, options.drift_length_mm, kind.smallest_sd};
  result = told(without_crumbs(with_border_refined(std::move(result.mask), image, look)), *settled);
  progress.report(1.0, GLISSON_TEXT("Smoothing the outline"));
  return result;
}

namespace {

Result<Settled> settled_region(const WorkingImage& working, const std::vector<Seed>& seeds, TissueModel::Drift drift,
                               double smallest_sd, const GrowOptions& options, const Progress& progress) {
  Settled settled;
  Region& region = settled.region;
  TissueModel& tissue = settled.tissue;
  tissue = learn_tissue(working, mask_of_seeds(seeds, working.grid), drift, options.drift_length_mm, smallest_sd);
  tissue.sd = smallest_sd;
  for (const Seed& seed : seeds) tissue.sd = std::max(tissue.sd, seed.sd);
  std::vector<std::uint8_t> before;
  for (settled.rounds = 1; settled.rounds <= maximum_rounds; ++settled.rounds) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(settled.rounds) / (maximum_rounds + 2), GLISSON_TEXT("Growing"));
    Mask looks = looks_like(tissue, working, options);
    for (const Seed& seed : seeds) {
      for (const std::size_t voxel : seed.voxels) looks.values[voxel] = 1;
    }
    region = region_of(with_slice_holes_filled(looks, options.closing_radius_mm + 2), seeds, options);
    if (voxel_count(region.core) == 0) {
      return failure(Error{"grow-nothing-found",
                           GLISSON_TEXT("No tissue thick enough to be an organ hangs together with the seeds."),
                           {},
                           GLISSON_TEXT("Move the seed into the middle of the liver, away from vessels and edges."),
                           {}});
    }
    if (!before.empty() && changed_fraction(before, region.whole.values) < settled_fraction) break;
    before = region.whole.values;
    tissue = learn_tissue(working, region.core, drift, options.drift_length_mm, smallest_sd);
  }
  settled.rounds = std::min(settled.rounds, maximum_rounds);
  return settled;
}

std::optional<double> stable_tolerance(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm,
                                       double narrow_ml, TissueModel::Drift drift, double smallest_sd,
                                       const GrowOptions& options, const Progress& progress) {
  constexpr double coarser = 1.6;                        // times the working spacing
  constexpr double much_more = 1.2, nearly_same = 1.05;  // times the volume
  const WorkingImage coarse =
      block_means(image.grid, image.values, blocks_of(image.grid, coarser * options.working_spacing_mm));
  const auto seeds = look_around_seeds(coarse, seeds_mm, options);
  if (!seeds) return std::nullopt;
  const auto ml_at = [&](double times) -> double {
    const auto grown = settled_region(coarse, *seeds, drift, smallest_sd, at_tolerance(options, times), progress);
    return grown ? volume_ml(grown->region.whole) : 0.0;
  };
  double before = ml_at(2);
  for (const double times : {2.0, 2.5}) {
    if (progress.cancelled()) return std::nullopt;
    const double after = ml_at(times + 0.5);
    if (before >= much_more * narrow_ml && after <= nearly_same * before) return times;
    if (after > largest_liver_ml) return std::nullopt;
    before = after;
  }
  return std::nullopt;
}

GrowOptions at_tolerance(GrowOptions options, double times) {
  options.tolerance_sd *= times;
  options.roughness_sd *= times;
  return options;
}

Region region_of(const Mask& tissue, const std::vector<Seed>& seeds, const GrowOptions& options) {
  Region region;
  region.core = with_margin(tissue, -options.neck_radius_mm);
  std::vector<std::size_t> in_core;
  for (const Seed& seed : seeds) {
    // A seed near the liver's surface lies outside the core: the nearest part of the core around it is meant.
    const double reach_mm = options.neck_radius_mm + options.sample_radius_mm;
    const auto nearest = nearest_voxel(seed.position_mm, reach_mm, region.core);
    region.holds_seed.push_back(nearest.has_value());
    if (nearest) in_core.push_back(*nearest);
  }
  region.core = joined_to(in_core, region.core, imaging::Neighbours::faces);
  // Balls that fit, and half a voxel more for the rim that the grid rounds away.
  region.whole = with_margin(region.core, options.neck_radius_mm + 0.5 * tissue.grid.spacing_mm.maxCoeff());
  for (std::size_t voxel = 0; voxel < tissue.values.size(); ++voxel) {
    if (tissue.values[voxel] == 0) region.whole.values[voxel] = 0;
  }
  return region;
}

// Vessels and tumours closed, the outline smoothed, on the image's own grid.
Mask finished(const Region& region, const Grid& grid, const std::array<int, 3>& block, const GrowOptions& options) {
  Mask closed = with_margin(with_margin(region.whole, options.closing_radius_mm), -options.closing_radius_mm);
  closed = fill_holes(closed);
  const double spacing_mm = closed.grid.spacing_mm.maxCoeff();
  closed = smooth(std::move(closed), 0.7 * spacing_mm);

  // A rim of blocks outside, so that the level falls to 0 within.
  const Part held = part_around(closed, 1);
  const Mask blocks = cut_out(closed, held);
  Part part{{}, grid};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.first[axis] = held.first[axis] * block[axis];
    part.grid.size[axis] = std::min(blocks.grid.size[axis] * block[axis], grid.size[axis] - part.first[axis]);
  }
  part.grid.origin_mm = grid.position_mm(part.first[0], part.first[1], part.first[2]);
  const imaging::Image<float> level{blocks.grid, std::vector<float>(blocks.values.begin(), blocks.values.end())};
  const std::vector<float> fine = interpolated(level, part.grid, block);
  Mask piece{part.grid, std::vector<std::uint8_t>(fine.size())};
  for (std::size_t voxel = 0; voxel < fine.size(); ++voxel) piece.values[voxel] = fine[voxel] >= 0.5F ? 1 : 0;
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  put_back(piece, part, mask);
  return mask;
}

// Crumbs that smoothing broke off go; pieces that hold seeds of their own stay.
Mask without_crumbs(Mask mask) {
  const Part part = part_around(mask, 0);
  Mask held = cut_out(mask, part);
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(held, imaging::Neighbours::faces);
  const std::size_t crumb = connected.sizes[connected.largest()] / 100;
  for (std::size_t voxel = 0; voxel < held.values.size(); ++voxel) {
    if (connected.sizes[connected.piece[voxel]] <= crumb) held.values[voxel] = 0;
  }
  put_back(held, part, mask);
  return mask;
}

Result<std::vector<Seed>> look_around_seeds(const WorkingImage& image, const std::vector<Vector3d>& seeds_mm,
                                            const GrowOptions& options) {
  const std::vector<float> smooth_image = smoothed(image, options.smoothing_mm);
  std::vector<Seed> seeds;
  for (std::size_t n = 0; n < seeds_mm.size(); ++n) {
    Seed seed{seeds_mm[n], {}, 0, 0};
    std::vector<float> brightness, single;
    std::vector<std::size_t> around;
    for (const std::size_t voxel : voxels_around(seed.position_mm, options.sample_radius_mm, image.grid)) {
      if (!std::isfinite(image.values[voxel])) continue;
      around.push_back(voxel);
      brightness.push_back(smooth_image[voxel]);
      single.push_back(image.values[voxel]);
    }
    if (around.empty()) {
      return failure("grow-seed-on-nothing", GLISSON_TEXT("There is no image value around seed {0}."),
                     {std::to_string(n + 1)});
    }
    seed.brightness = mode_of(brightness);
    for (float& value : single) value = std::abs(value - static_cast<float>(seed.brightness));
    seed.sd = 1.4826 * upper_median(std::move(single));
    for (const std::size_t voxel : around) {
      const double off = std::abs(static_cast<double>(smooth_image[voxel]) - seed.brightness);
      if (off <= options.tolerance_sd * seed.sd) seed.voxels.push_back(voxel);
    }
    seeds.push_back(std::move(seed));
  }
  return seeds;
}

Result<void> check(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm, const GrowOptions& options) {
  for (const double value :
       {options.sample_radius_mm, options.working_spacing_mm, options.smoothing_mm, options.tolerance_sd,
        options.roughness_sd, options.drift_length_mm, options.neck_radius_mm, options.closing_radius_mm}) {
    if (std::isfinite(value) && value > 0) continue;
    return failure("grow-bad-options", GLISSON_TEXT("The options of growing must be positive, and one is {0}."),
                   {fmt::format("{}", value)});
  }
  return check_seeds(image, seeds_mm);
}

Mask mask_of_seeds(const std::vector<Seed>& seeds, const Grid& grid) {
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (const Seed& seed : seeds) {
    for (const std::size_t voxel : seed.voxels) mask.values[voxel] = 1;
  }
  return mask;
}

// The voxels that differ, as a part of those after.
double changed_fraction(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after) {
  std::size_t changed = 0, inside = 0;
  for (std::size_t voxel = 0; voxel < after.size(); ++voxel) {
    changed += before[voxel] != after[voxel] ? 1U : 0U;
    inside += after[voxel];
  }
  return static_cast<double>(changed) / static_cast<double>(std::max<std::size_t>(inside, 1));
}

}  // namespace
}  // namespace glisson::segmentation
