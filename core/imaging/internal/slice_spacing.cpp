// ITK and DCMTK spread a gap over all slices (1.5 mm became 1.515 mm where one of 100 slices was absent). Here the
// spacing stays what it is, and the gap is named and filled.

#include "imaging/internal/slice_spacing.h"

#include <algorithm>
#include <cmath>

#include "base/result.h"

namespace glisson::imaging {
namespace {

// Positions are written with a few decimals, and tables move by hundredths of a millimetre.
constexpr double unevenness_allowed = 0.01;
constexpr double unevenness_allowed_mm = 0.01;
constexpr double off_grid_allowed = 0.05;

SliceBlend blend_at(const std::vector<double>& positions_mm, double target_mm, double allowed_mm) {
  const auto after = std::lower_bound(positions_mm.begin(), positions_mm.end(), target_mm);
  const std::size_t above =
      std::min<std::size_t>(static_cast<std::size_t>(after - positions_mm.begin()), positions_mm.size() - 1);
  const std::size_t below = above == 0 ? 0 : above - 1;
  const double distance_above = std::abs(positions_mm[above] - target_mm);
  const double distance_below = std::abs(positions_mm[below] - target_mm);
  if (std::min(distance_above, distance_below) <= allowed_mm) {
    const std::size_t nearest = distance_above <= distance_below ? above : below;
    return {nearest, nearest, 0};
  }
  return {below, above, distance_below / (distance_below + distance_above)};
}

}  // namespace

EvenSlices even_slices(const std::vector<double>& positions_mm) {
  GLISSON_ASSERT(positions_mm.size() >= 2);
  EvenSlices even;
  const double usual_mm = usual_gap_mm(positions_mm);
  even.usual_gap_mm = usual_mm;
  const double length_mm = positions_mm.back() - positions_mm.front();
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(length_mm / usual_mm)));
  even.spacing_mm = length_mm / static_cast<double>(steps);
  for (std::size_t k = 0; k <= steps; ++k) {
    const double target_mm = positions_mm.front() + even.spacing_mm * static_cast<double>(k);
    even.slices.push_back(blend_at(positions_mm, target_mm, off_grid_allowed * even.spacing_mm));
  }
  for (std::size_t i = 0; i + 1 < positions_mm.size(); ++i) {
    const double width_mm = positions_mm[i + 1] - positions_mm[i];
    if (std::abs(width_mm - usual_mm) <= std::max(unevenness_allowed * usual_mm, unevenness_allowed_mm)) continue;
    const double multiple = std::round(width_mm / usual_mm);
    const bool whole_slices = multiple >= 2 && std::abs(width_mm - multiple * usual_mm) <= 0.1 * usual_mm;
    even.gaps.push_back({i, width_mm, whole_slices ? static_cast<int>(multiple) - 1 : 0});
  }
  return even;
}

double usual_gap_mm(const std::vector<double>& positions_mm) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < positions_mm.size(); ++i) gaps.push_back(positions_mm[i + 1] - positions_mm[i]);
  if (gaps.empty()) return 0;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>((gaps.size() - 1) / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

}  // namespace glisson::imaging
