#include "segmentation/internal/growth_doubts.h"

#include <fmt/format.h>
#include <algorithm>

namespace glisson::segmentation {
namespace {

constexpr double much_unsure_border = 0.3;

}  // namespace

std::vector<GrowResult::Doubt> doubts_about(const GrowResult& result, const std::vector<double>& seed_brightness,
                                            const std::vector<bool>& holds_seed) {
  std::vector<GrowResult::Doubt> doubts;
  const auto [darkest, brightest] = std::minmax_element(seed_brightness.begin(), seed_brightness.end());
  if (*brightest - *darkest > 3 * result.tissue_sd) {
    doubts.push_back(
        {GrowthDoubt::seeds_disagree,
         {GLISSON_TEXT("Seed {0} is much brighter ({1}) than seed {2} ({3}): one of them is probably not in the liver. "
                       "Take it away."),
          {std::to_string(brightest - seed_brightness.begin() + 1), fmt::format("{:.0f}", *brightest),
           std::to_string(darkest - seed_brightness.begin() + 1), fmt::format("{:.0f}", *darkest)}}});
  }
  for (std::size_t n = 0; n < holds_seed.size(); ++n) {
    if (holds_seed[n]) continue;
    doubts.push_back({GrowthDoubt::seed_ignored,
                      {GLISSON_TEXT("Nothing grew from seed {0}: the tissue around it is too thin or uneven. Move it "
                                    "to the middle of the liver."),
                       {std::to_string(n + 1)}}});
  }

  bool first_or_last_slice = false, other_face = false;
  const imaging::Grid& grid = result.mask.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (result.mask.at(i, j, k) == 0) continue;
        if (k == 0 || k + 1 == grid.size[2]) first_or_last_slice = true;
        if (i == 0 || j == 0 || i + 1 == grid.size[0] || j + 1 == grid.size[1]) other_face = true;
      }
    }
  }
  if (result.unsure_border > much_unsure_border && !result.unsure_places_mm.empty()) {
    std::string places;
    for (const Eigen::Vector3d& place_mm : result.unsure_places_mm) {
      places += fmt::format("{}({:.0f}, {:.0f}, {:.0f})", places.empty() ? "" : ", ", place_mm.x(), place_mm.y(),
                            place_mm.z());
    }
    doubts.push_back(
        {GrowthDoubt::unsure_border,
         {GLISSON_TEXT("On {0} % of its border the outline lies on tissue that hardly differs from it, most "
                       "of all at {1} (LPS, mm): look there before you trust it, and add a point where a "
                       "part is missing."),
          {fmt::format("{:.0f}", 100 * result.unsure_border), places}}});
  }
  const std::string volume_ml = fmt::format("{:.0f}", result.volume_ml);
  if (other_face) {
    doubts.push_back({GrowthDoubt::leaves_image,
                      {GLISSON_TEXT("The region reaches the side of the image: it has probably leaked into the body "
                                    "wall. Cut it there, or raise neck_radius_mm."),
                       {}}});
  }
  if (first_or_last_slice) {
    doubts.push_back({GrowthDoubt::cut_by_image,
                      {GLISSON_TEXT("The region reaches the first or last slice: the liver is not wholly in the image, "
                                    "and its volume is that of the part seen."),
                       {}}});
  }
  if (result.volume_ml > largest_liver_ml) {
    doubts.push_back({GrowthDoubt::too_large,
                      {GLISSON_TEXT("{0} ml is more than a liver holds: the region has probably leaked into a "
                                    "neighbour. Raise neck_radius_mm, or cut it by hand."),
                       {volume_ml}}});
  }
  if (result.volume_ml < smallest_liver_ml && !first_or_last_slice) {
    doubts.push_back({GrowthDoubt::too_small,
                      {GLISSON_TEXT("{0} ml is less than an adult's liver holds: the growth has probably stopped "
                                    "early. Add a seed in the part that is missing, or raise tolerance_sd."),
                       {volume_ml}}});
  }
  return doubts;
}

bool GrowResult::probably_leaked() const {
  return std::any_of(doubts.begin(), doubts.end(), [](const Doubt& doubt) {
    return doubt.kind == GrowthDoubt::leaves_image || doubt.kind == GrowthDoubt::too_large ||
           doubt.kind == GrowthDoubt::seeds_disagree;
  });
}

}  // namespace glisson::segmentation
