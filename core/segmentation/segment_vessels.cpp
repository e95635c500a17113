// The organ on a grid of cubic voxels, tubes in it, and from their axes out to where they end.

#include "segmentation/segment_vessels.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/internal/tubularity.h"
#include "segmentation/resample.h"
#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

// The organ and what it holds, on cubic voxels; beyond it the brightness at its border goes on.
struct Organ {
  imaging::Image<float> image;
  Mask mask;
};
Organ organ_on_cubes(const imaging::Volume& image, const Mask& organ);

// The tubes of one sign.
struct Tubes {
  int sign = 1;
  Tubularity shape;
  Mask axes;            // the voxels that are sure, and those likely that hang on them
  double contrast = 0;  // of the clearest of them
  double evidence = 0;  // sum of their contrasts' squares
};
Tubes tubes_of(const Organ& organ, int sign, const SegmentVesselsOptions& options, const Progress& progress);

// Those of the brightness asked for; else in CT the bright ones, or of both signs those of more contrast.
Tubes likelier_tubes(const Organ& organ, bool is_ct, const SegmentVesselsOptions& options, const Progress& progress);

// The axes' voxels and those around them that are nearer in brightness to the vessel than to the tissue.
Mask widened(const Organ& organ, const Tubes& tubes);

Mask without_short_pieces(Mask mask, double shortest_mm);
double brightness_within(const imaging::Volume& image, const Mask& mask);  // median
Sentence note_of(const SegmentedVessels& found, double organ_ml);
Result<Mask> hanging_on(const Mask& vessels, const std::vector<Vector3d>& seeds_mm);

}  // namespace

Result<SegmentedVessels> segment_vessels(const imaging::Volume& image, const Mask& organ,
                                         const std::vector<Vector3d>& seeds_mm, const SegmentVesselsOptions& options,
                                         const Progress& progress) {
  GLISSON_ASSERT(imaging::same_grid(organ.grid, image.grid));
  const auto checked = seeds_mm.empty() ? check_image(image) : check_seeds(image, seeds_mm);
  if (!checked) return failure(checked.error());
  if (voxel_count(organ) == 0) {
    return failure("vessels-no-organ", GLISSON_TEXT("The outline to find vessels in holds nothing."));
  }
  progress.report(0, GLISSON_TEXT("Finding vessels"));
  const Organ cubes = organ_on_cubes(image, organ);
  const Tubes tubes = likelier_tubes(cubes, image.unit == "HU", options, progress.part(0.1, 0.9));
  if (progress.cancelled()) return cancelled();
  SegmentedVessels found;
  found.mask = {image.grid, std::vector<std::uint8_t>(image.grid.voxels(), 0)};
  if (tubes.evidence > 0) {
    Mask vessels = without_short_pieces(widened(cubes, tubes), options.shortest_mm);
    if (!seeds_mm.empty()) {
      auto kept = hanging_on(vessels, seeds_mm);
      if (!kept) return failure(kept.error());
      vessels = std::move(*kept);
    }
    found.mask = resample(vessels, image.grid);
  }
  if (voxel_count(found.mask) == 0) {
    return failure(Error{"vessels-none",
                         GLISSON_TEXT("Nothing in the outline stands out as a tube."),
                         {},
                         GLISSON_TEXT("Vessels need contrast: take another phase or sequence, grow them from seeds, or "
                                      "import their outline."),
                         {}});
  }
  found.volume_ml = volume_ml(found.mask);
  found.brightness = tubes.sign > 0 ? VesselBrightness::bright : VesselBrightness::dark;
  found.contrast = brightness_within(image, found.mask) - brightness_within(image, subtracted(organ, found.mask));
  found.notes = {note_of(found, volume_ml(organ))};
  progress.report(1, GLISSON_TEXT("Finding vessels"));
  return found;
}

namespace {

constexpr double finest_mm = 0.8;  // no vessel that is looked for is thinner
constexpr std::size_t most_voxels = 24'000'000;
constexpr double rim_mm = 12;  // around the organ, so that blurs end in it

Grid cubes_over(const Grid& part) {
  const Vector3d extent_mm = part.spacing_mm.cwiseProduct(Vector3d(part.size[0], part.size[1], part.size[2]));
  const double smallest_mm = std::cbrt(extent_mm.prod() / static_cast<double>(most_voxels));
  const double spacing_mm = std::max({finest_mm, part.spacing_mm.minCoeff(), smallest_mm});
  Grid cubes = part;
  cubes.spacing_mm.setConstant(spacing_mm);
  for (int a = 0; a < 3; ++a) {
    cubes.size[static_cast<std::size_t>(a)] = std::max(3, static_cast<int>(std::ceil(extent_mm[a] / spacing_mm)));
  }
  return cubes;
}

Organ organ_on_cubes(const imaging::Volume& image, const Mask& organ) {
  const Mask whole = imaging::fill_holes(organ);
  const Part box = part_around(whole, 0);
  const Vector3d last(box.grid.size[0] - 1, box.grid.size[1] - 1, box.grid.size[2] - 1);
  const Part part = part_around({box.grid.position_mm(0, 0, 0), box.grid.position_mm(last)}, rim_mm, image.grid);
  imaging::Image<float> sharp = cut_out<float>(image, part);
  const Mask inside = cut_out(whole, part);
  for (std::size_t n = 0; n < sharp.values.size(); ++n) {
    if (inside.values[n] == 0) sharp.values[n] = std::numeric_limits<float>::quiet_NaN();
  }
  double sum = 0, count = 0;
  for (const float value : sharp.values) {
    if (std::isfinite(value)) sum += static_cast<double>(value), ++count;
  }
  const auto mean = static_cast<float>(count > 0 ? sum / count : 0);
  const std::vector<float> going_on = smoothed(sharp, 4);
  for (std::size_t n = 0; n < sharp.values.size(); ++n) {
    if (std::isfinite(sharp.values[n])) continue;
    sharp.values[n] = std::isfinite(going_on[n]) ? going_on[n] : mean;
  }
  const Grid cubes = cubes_over(part.grid);
  return {resample(sharp, cubes), resample(inside, cubes)};
}

std::vector<double> radii_between(double narrowest_mm, double widest_mm) {
  std::vector<double> radii_mm;
  for (double radius_mm = narrowest_mm; radius_mm < 1.01 * widest_mm; radius_mm *= 1.45) radii_mm.push_back(radius_mm);
  return radii_mm;
}

Tubes tubes_of(const Organ& organ, int sign, const SegmentVesselsOptions& options, const Progress& progress) {
  Tubes tubes;
  tubes.sign = sign;
  tubes.shape =
      tubularity(organ.image, organ.mask, radii_between(options.narrowest_mm, options.widest_mm), sign, progress);
  if (tubes.shape.contrast.empty()) return tubes;
  const std::vector<float>&contrast = tubes.shape.contrast, &to_noise = tubes.shape.to_noise;
  std::vector<float> of_sure;
  for (std::size_t n = 0; n < contrast.size(); ++n) {
    if (static_cast<double>(to_noise[n]) > options.sure_to_noise) of_sure.push_back(contrast[n]);
  }
  if (of_sure.empty()) return tubes;
  const auto clear = of_sure.begin() + static_cast<std::ptrdiff_t>(9 * of_sure.size() / 10);
  std::nth_element(of_sure.begin(), clear, of_sure.end());
  tubes.contrast = static_cast<double>(*clear);
  const double smallest = options.share_of_contrast * tubes.contrast;
  Mask likely{organ.mask.grid, std::vector<std::uint8_t>(contrast.size(), 0)};
  std::vector<std::size_t> sure;
  for (std::size_t n = 0; n < contrast.size(); ++n) {
    if (static_cast<double>(contrast[n]) < smallest) continue;
    likely.values[n] = static_cast<double>(to_noise[n]) > options.likely_to_noise ? 1 : 0;
    if (static_cast<double>(to_noise[n]) > options.sure_to_noise) sure.push_back(n);
  }
  tubes.axes = joined_to(sure, likely);
  for (std::size_t n = 0; n < contrast.size(); ++n) {
    if (tubes.axes.values[n] != 0) tubes.evidence += std::pow(static_cast<double>(contrast[n]), 2);
  }
  return tubes;
}

Tubes likelier_tubes(const Organ& organ, bool is_ct, const SegmentVesselsOptions& options, const Progress& progress) {
  if (options.brightness || is_ct) {
    const bool dark = options.brightness.value_or(VesselBrightness::bright) == VesselBrightness::dark;
    return tubes_of(organ, dark ? -1 : 1, options, progress);
  }
  Tubes bright = tubes_of(organ, 1, options, progress.part(0, 0.5));
  Tubes dark = tubes_of(organ, -1, options, progress.part(0.5, 1));
  return dark.evidence > bright.evidence ? dark : bright;
}

// Mean of `values` over the voxels of these weights, near each voxel; NaN where none is near.
std::vector<float> mean_near(const imaging::Image<float>& image, const std::vector<float>& weights, double sd_mm) {
  std::vector<float> weighted(weights.size());
  for (std::size_t n = 0; n < weights.size(); ++n) weighted[n] = weights[n] * image.values[n];
  std::vector<float> means = imaging::gaussian_blur(std::move(weighted), image.grid, sd_mm);
  const std::vector<float> all = imaging::gaussian_blur(weights, image.grid, sd_mm);
  const float largest = *std::max_element(weights.begin(), weights.end());
  for (std::size_t n = 0; n < means.size(); ++n) {
    means[n] = all[n] > 1e-4F * largest ? means[n] / all[n] : std::numeric_limits<float>::quiet_NaN();
  }
  return means;
}

// From each axis voxel outwards as far as its own radius, over voxels beyond half-way from tissue to vessel.
Mask widened(const Organ& organ, const Tubes& tubes) {
  constexpr double smoothing_mm = 0.6, along_mm = 2, around_mm = 8, reach_of_radius = 1.3;
  const Grid& grid = organ.mask.grid;
  const Mask near_axes = with_margin(tubes.axes, 3);
  std::vector<float> tissue(grid.voxels()), vessel(grid.voxels());
  for (std::size_t n = 0; n < tissue.size(); ++n) {
    tissue[n] = organ.mask.values[n] != 0 && near_axes.values[n] == 0 ? 1.0F : 0.0F;
    vessel[n] = tubes.axes.values[n] != 0 ? tubes.shape.contrast[n] * tubes.shape.contrast[n] : 0.0F;
  }
  const imaging::Image<float> smooth{grid, imaging::gaussian_blur(organ.image.values, grid, smoothing_mm)};
  const std::vector<float> around = mean_near(smooth, tissue, around_mm), at_axis = mean_near(smooth, vessel, along_mm);
  const auto belongs = [&](std::size_t n) {
    if (organ.mask.values[n] == 0 || !std::isfinite(around[n]) || !std::isfinite(at_axis[n])) return false;
    return static_cast<float>(tubes.sign) * (smooth.values[n] - 0.5F * (around[n] + at_axis[n])) > 0;
  };
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  struct Front {
    int i, j, k;
    std::size_t axis;  // where it set out
  };
  std::vector<Front> front;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t n = grid.offset(i, j, k);
        if (tubes.axes.values[n] == 0 || !belongs(n)) continue;
        mask.values[n] = 1;
        front.push_back({i, j, k, n});
      }
    }
  }
  for (std::size_t next = 0; next < front.size(); ++next) {
    const Front at = front[next];
    const double reach = reach_of_radius * static_cast<double>(tubes.shape.radius_mm[at.axis]) / grid.spacing_mm.x();
    for (const auto& step :
         std::array<std::array<int, 3>, 6>{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}}) {
      const Eigen::Vector3i to(at.i + step[0], at.j + step[1], at.k + step[2]);
      if (!grid.contains(to.x(), to.y(), to.z())) continue;
      const std::size_t n = grid.offset(to.x(), to.y(), to.z());
      if (mask.values[n] != 0 || !belongs(n) || (to - index_of(at.axis, grid)).cast<double>().norm() > reach) continue;
      mask.values[n] = 1;
      front.push_back({to.x(), to.y(), to.z(), at.axis});
    }
  }
  return imaging::fill_holes(mask);
}

Mask without_short_pieces(Mask mask, double shortest_mm) {
  const imaging::ConnectedVoxels pieces = imaging::connected_voxels(mask, imaging::Neighbours::all);
  std::vector<Eigen::Array3i> low(pieces.sizes.size(), Eigen::Array3i::Constant(std::numeric_limits<int>::max()));
  std::vector<Eigen::Array3i> high(pieces.sizes.size(), Eigen::Array3i::Constant(-1));
  std::size_t n = 0;
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i, ++n) {
        const std::uint32_t piece = pieces.piece[n];
        low[piece] = low[piece].min(Eigen::Array3i(i, j, k));
        high[piece] = high[piece].max(Eigen::Array3i(i, j, k));
      }
    }
  }
  for (n = 0; n < mask.values.size(); ++n) {
    const std::uint32_t piece = pieces.piece[n];
    if (piece == 0) continue;
    const double length_mm = ((high[piece] - low[piece]).cast<double>() * mask.grid.spacing_mm.array()).matrix().norm();
    if (length_mm < shortest_mm) mask.values[n] = 0;
  }
  return mask;
}

double brightness_within(const imaging::Volume& image, const Mask& mask) {
  std::vector<float> values;
  for (std::size_t n = 0; n < image.values.size(); ++n) {
    if (mask.values[n] != 0 && std::isfinite(image.values[n])) values.push_back(image.values[n]);
  }
  return upper_median(std::move(values));
}

Sentence note_of(const SegmentedVessels& found, double organ_ml) {
  return {found.brightness == VesselBrightness::bright
              ? GLISSON_TEXT("Vessels are brighter than the tissue around by {0}: {1} ml, {2} % of the outline.")
              : GLISSON_TEXT("Vessels are darker than the tissue around by {0}: {1} ml, {2} % of the outline."),
          {fmt::format("{:.0f}", std::abs(found.contrast)), fmt::format("{:.1f}", found.volume_ml),
           fmt::format("{:.1f}", 100 * found.volume_ml / organ_ml)}};
}

Result<Mask> hanging_on(const Mask& vessels, const std::vector<Vector3d>& seeds_mm) {
  constexpr double reach_mm = 5;
  std::vector<std::size_t> nearest;  // to each seed
  for (const Vector3d& seed_mm : seeds_mm) {
    const auto voxel = nearest_voxel(seed_mm, reach_mm, vessels);
    if (!voxel) {
      return failure(Error{"vessels-seed-off",
                           GLISSON_TEXT("The seed at ({0}) mm lies more than {1} mm from every vessel found."),
                           {fmt::format("{:.1f}, {:.1f}, {:.1f}", seed_mm.x(), seed_mm.y(), seed_mm.z()),
                            fmt::format("{:.0f}", reach_mm)},
                           GLISSON_TEXT("Move the seed onto a vessel, or leave seeds out: then all vessels are kept."),
                           {}});
    }
    nearest.push_back(*voxel);
  }
  return joined_to(nearest, vessels);
}

}  // namespace
}  // namespace glisson::segmentation
