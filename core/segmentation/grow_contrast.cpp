// Growing by contrast: what the seeds and their surroundings look like, what hangs together with the seeds, and what of
// it is too thick, or hangs on by a neck.

#include "segmentation/grow_contrast.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/result.h"
#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

// What tells the structure from its surroundings: values from low to high are the structure's.
struct Appearance {
  double seeds = 0;
  double around = 0;
  double noise = 0;  // standard deviation of the smoothed voxels around
  double low = 0, high = 0;
  [[nodiscard]] double contrast() const { return std::abs(seeds - around); }
};
std::optional<Appearance> learn_appearance(const imaging::Image<float>& image, const Mask& allowed,
                                           const std::vector<Vector3d>& seeds_mm, Contrast kind,
                                           const ContrastOptions& options);

std::vector<std::size_t> voxels_of_seeds(const Mask& allowed, const std::vector<Vector3d>& seeds_mm, double radius_mm);
Mask without_thick_parts(Mask mask, double widest_mm);
Mask without_necks(const Mask& mask, const std::vector<std::size_t>& seeds, double share);
bool touches_side(const Mask& mask);

constexpr double minimum_contrast_to_noise = 2.5;
// Half-way between the two, one voxel in 160 is taken for the other by noise.
constexpr double sure_contrast_to_noise = 5;

}  // namespace

std::optional<Contrast> contrast_of(std::string_view structure) {
  const auto holds = [&](std::string_view part) { return structure.find(part) != std::string_view::npos; };
  if (holds("vein") || holds("arter") || holds("vena-cava") || holds("aorta") || holds("biliary") || holds("vessel")) {
    return Contrast::vessel;
  }
  if (holds("tumour") || holds("cyst") || holds("necrosis") || holds("gallbladder") || holds("lesion")) {
    return Contrast::lesion;
  }
  return std::nullopt;
}

Result<ContrastGrowth> grow_contrast(const imaging::Volume& image, const std::vector<Vector3d>& seeds_mm, Contrast kind,
                                     const Mask* within, const ContrastOptions& options, const Progress& progress) {
  if (Result<void> checked = check_seeds(image, seeds_mm); !checked) return failure(checked.error());
  GLISSON_ASSERT(within == nullptr || imaging::same_grid(within->grid, image.grid));
  progress.report(0, GLISSON_TEXT("Growing"));
  const Part part = part_around(seeds_mm, options.reach_mm, image.grid);
  const imaging::Image<float> sharp_image = cut_out<float>(image, part);
  Mask allowed{part.grid, std::vector<std::uint8_t>(part.grid.voxels(), 1)};
  if (within != nullptr) allowed = cut_out(*within, part);
  for (std::size_t voxel = 0; voxel < allowed.values.size(); ++voxel) {
    if (!std::isfinite(sharp_image.values[voxel])) allowed.values[voxel] = 0;
  }
  const std::vector<std::size_t> seeds = voxels_of_seeds(allowed, seeds_mm, 0);
  if (seeds.size() < seeds_mm.size()) {
    return failure(
        Error{"grow-seed-on-nothing",
              GLISSON_TEXT("A seed lies where there is no image value, or outside of the structure to stay in."),
              {},
              GLISSON_TEXT("Forget the points, and click inside of it."),
              {}});
  }
  // Smoothed as little as the noise allows: thin vessels vanish in a wide blur.
  imaging::Image<float> smooth_image{part.grid, {}};
  std::optional<Appearance> look;
  for (const double wider : {1.0, 1.5, 2.25}) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.3 * wider / 2.25, GLISSON_TEXT("Growing"));
    smooth_image.values = smoothed(sharp_image, wider * options.smoothing_mm);
    look = learn_appearance(smooth_image, allowed, seeds_mm, kind, options);
    const bool is_sure = look && look->contrast() >= sure_contrast_to_noise * look->noise;
    if (is_sure || kind == Contrast::vessel) break;
  }
  if (!look || look->contrast() < minimum_contrast_to_noise * look->noise) {
    return failure(Error{"grow-no-contrast",
                         GLISSON_TEXT("Nothing around the seeds differs from them in brightness."),
                         {},
                         GLISSON_TEXT("Move the seeds, or draw with the brush."),
                         {}});
  }
  Mask looks{part.grid, std::vector<std::uint8_t>(part.grid.voxels(), 0)};
  for (std::size_t voxel = 0; voxel < looks.values.size(); ++voxel) {
    const double value = smooth_image.values[voxel];
    looks.values[voxel] = allowed.values[voxel] != 0 && value >= look->low && value <= look->high ? 1 : 0;
  }
  for (const std::size_t seed : seeds) looks.values[seed] = 1;
  const Mask hanging = joined_to(seeds, looks);
  if (progress.cancelled()) return cancelled();
  progress.report(0.6, GLISSON_TEXT("Growing"));

  // From here on only the part that anything grew in is looked at.
  const Part grown_in = part_around(hanging, 2);
  Mask grown = cut_out(hanging, grown_in);
  const Mask allowed_here = cut_out(allowed, grown_in);
  std::vector<std::size_t> seeds_here = voxels_of_seeds(allowed_here, seeds_mm, 0);
  if (kind == Contrast::vessel) {
    grown = without_thick_parts(std::move(grown), options.widest_vessel_mm);
    std::erase_if(seeds_here, [&](std::size_t seed) { return grown.values[seed] == 0; });
    if (seeds_here.empty()) {
      return failure(
          Error{"grow-only-thick",
                GLISSON_TEXT("What is as bright as the seeds and hangs together with them is more than {0} mm "
                             "thick: no vessel."),
                {fmt::format("{:.0f}", options.widest_vessel_mm)},
                GLISSON_TEXT("Move the seed into a vessel that stands out, or keep the growth inside of the "
                             "liver."),
                {}});
    }
    grown = joined_to(seeds_here, grown);
  } else {
    grown = imaging::fill_holes(without_necks(grown, seeds_here, options.neck_share));
  }

  ContrastGrowth result;
  Mask in_part{part.grid, std::vector<std::uint8_t>(part.grid.voxels(), 0)};
  put_back(grown, grown_in, in_part);
  result.mask = {image.grid, std::vector<std::uint8_t>(image.grid.voxels(), 0)};
  put_back(in_part, part, result.mask);
  result.volume_ml = volume_ml(result.mask);
  result.brightness = look->seeds;
  result.surroundings = look->around;
  if (look->contrast() < sure_contrast_to_noise * look->noise) {
    result.doubts.push_back(
        {GLISSON_TEXT(
             "The seeds ({0}) hardly stand out from the tissue around ({1}, scatter {2}): look at the outline."),
         {fmt::format("{:.0f}", look->seeds), fmt::format("{:.0f}", look->around),
          fmt::format("{:.0f}", look->noise)}});
  }
  if (within == nullptr && touches_side(result.mask)) {
    result.doubts.push_back({GLISSON_TEXT("The growth reaches the side of the image: it has probably leaked. Keep it "
                                          "inside of the liver, or cut it there."),
                             {}});
  }
  progress.report(1, GLISSON_TEXT("Growing"));
  return result;
}

namespace {

// The ball around the seeds is widened until what differs from them, by more than they scatter, fills a good part of
// it.
std::optional<Appearance> learn_appearance(const imaging::Image<float>& image, const Mask& allowed,
                                           const std::vector<Vector3d>& seeds_mm, Contrast kind,
                                           const ContrastOptions& options) {
  constexpr double minimum_share = 0.4;
  const double sample_mm = std::max(options.sample_radius_mm, 1.5 * image.grid.spacing_mm.minCoeff());
  std::vector<float> at_seeds, scatter;
  for (const std::size_t voxel : voxels_of_seeds(allowed, seeds_mm, sample_mm)) {
    at_seeds.push_back(image.values[voxel]);
  }
  Appearance look;
  look.seeds = upper_median(at_seeds);
  const auto off = [&](float value) { return std::abs(static_cast<double>(value) - look.seeds); };
  for (const float value : at_seeds) scatter.push_back(static_cast<float>(off(value)));
  const double minimum_contrast =
      std::max(minimum_contrast_to_noise * 1.4826 * upper_median(std::move(scatter)), 1e-6 * std::abs(look.seeds));
  for (const double radius_mm : {12.0, 20.0, 32.0, 50.0}) {
    std::vector<float> values;
    for (const std::size_t voxel : voxels_of_seeds(allowed, seeds_mm, radius_mm)) values.push_back(image.values[voxel]);
    std::sort(values.begin(), values.end(), [&](float a, float b) { return off(a) < off(b); });
    const auto beyond = [&](double border) {
      return std::partition_point(values.begin(), values.end(), [&](float v) { return off(v) <= border; });
    };
    // Two classes, the seeds' held at their brightness: the border half-way to the other's, until it stays.
    double border = minimum_contrast, around = look.seeds;
    for (int round = 0; round < 20; ++round) {
      std::vector<float> differing(beyond(std::max(border, 0.6 * minimum_contrast)), values.end());
      if (differing.empty()) break;
      differing.resize((differing.size() + 1) / 2);  // the nearer half: fat and air around a vessel say nothing of it
      around = mode_of(differing);
      const double next = 0.5 * off(static_cast<float>(around));
      if (std::abs(next - border) < 1e-3 * next) break;
      border = next;
    }
    if (off(static_cast<float>(around)) < minimum_contrast) continue;
    if (static_cast<double>(values.end() - beyond(border)) < minimum_share * static_cast<double>(values.size()))
      continue;
    look.around = around;
    std::vector<float> around_scatter;
    for (auto value = beyond(border); value != beyond(3 * border); ++value) {
      around_scatter.push_back(std::abs(*value - static_cast<float>(around)));
    }
    look.noise = around_scatter.empty() ? 0 : 1.4826 * upper_median(std::move(around_scatter));
    const double contrast = look.seeds - look.around;
    // The middle of a vessel is brighter than its branches, whose voxels are shared with tissue.
    const double more = (kind == Contrast::vessel ? 1.5 : 0.6) * contrast;
    const double half_way = look.around + 0.5 * contrast, far = look.seeds + more;
    look.low = std::min(half_way, far);
    look.high = std::max(half_way, far);
    return look;
  }
  return std::nullopt;
}

// Of each seed the voxels within the radius, but at least the one that it lies in; nothing that is not allowed.
std::vector<std::size_t> voxels_of_seeds(const Mask& allowed, const std::vector<Vector3d>& seeds_mm, double radius_mm) {
  std::vector<std::size_t> all;
  for (const Vector3d& seed_mm : seeds_mm) {
    const Vector3d index = allowed.grid.index_of(seed_mm).array().round();
    const int i = static_cast<int>(index.x()), j = static_cast<int>(index.y()), k = static_cast<int>(index.z());
    if (allowed.grid.contains(i, j, k)) all.push_back(allowed.grid.offset(i, j, k));
    if (!(radius_mm > 0)) continue;
    const std::vector<std::size_t> around = voxels_around(seed_mm, radius_mm, allowed.grid);
    all.insert(all.end(), around.begin(), around.end());
  }
  if (radius_mm > 0) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  std::erase_if(all, [&](std::size_t voxel) { return allowed.values[voxel] == 0; });
  return all;
}

// Where a ball as thick as an organ fits, it goes, with a rim as wide as the ball: the organ, not the vessel at it.
Mask without_thick_parts(Mask mask, double widest_mm) {
  Mask thick = with_margin(mask, -0.5 * widest_mm);
  if (voxel_count(thick) == 0) return mask;
  thick = with_margin(std::move(thick), 0.5 * widest_mm + mask.grid.spacing_mm.maxCoeff());
  return subtracted(std::move(mask), thick);
}

// The balls of a share of the thickness at the seeds that fit and hang together there, and what they reach.
Mask without_necks(const Mask& mask, const std::vector<std::size_t>& seeds, double share) {
  const std::vector<float> depths_mm2 = imaging::squared_depths_mm2(mask);
  // Uphill from a seed by face neighbours: the middle of what it lies in.
  const auto uphill = [&](std::size_t at) {
    const std::array<std::size_t, 3> step{
        1, static_cast<std::size_t>(mask.grid.size[0]),
        static_cast<std::size_t>(mask.grid.size[0]) * static_cast<std::size_t>(mask.grid.size[1])};
    for (;;) {
      std::size_t best = at;
      for (const std::size_t by : step) {
        if (at >= by && depths_mm2[at - by] > depths_mm2[best]) best = at - by;
        if (at + by < depths_mm2.size() && depths_mm2[at + by] > depths_mm2[best]) best = at + by;
      }
      if (best == at) return at;
      at = best;
    }
  };
  std::vector<std::size_t> middles;
  double deepest_mm = 0;
  for (const std::size_t seed : seeds) {
    middles.push_back(uphill(seed));
    deepest_mm = std::max(deepest_mm, std::sqrt(static_cast<double>(depths_mm2[middles.back()])));
  }
  const double neck_mm = share * deepest_mm, voxel_mm = mask.grid.spacing_mm.maxCoeff();
  if (neck_mm < mask.grid.spacing_mm.minCoeff()) return mask;
  Mask core = mask;
  for (std::size_t voxel = 0; voxel < core.values.size(); ++voxel) {
    core.values[voxel] = static_cast<double>(depths_mm2[voxel]) > neck_mm * neck_mm ? 1 : 0;
  }
  core = joined_to(middles, core);
  return intersected(with_margin(std::move(core), neck_mm + 0.5 * voxel_mm), mask);
}

bool touches_side(const Mask& mask) {
  const std::array<int, 3>& size = mask.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if ((i == 0 || j == 0 || i + 1 == size[0] || j + 1 == size[1]) && mask.at(i, j, k) != 0) return true;
      }
    }
  }
  return false;
}

}  // namespace
}  // namespace glisson::segmentation
