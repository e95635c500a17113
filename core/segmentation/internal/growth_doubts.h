#pragma once
// Why what has grown may not be the liver: said beside it, never in its place.

#include <vector>

#include "segmentation/grow.h"

namespace glisson::segmentation {

// Adults' livers hold about -794 + 1267 BSA ml (Vauthey et al., Liver Transplantation 8:233, 2002). That is 0.7 l at
// 1.2 m2 of body surface, 2.5 l at 2.6 m2. Wider on both sides for small remnants and large, fatty livers.
constexpr double smallest_liver_ml = 500;
constexpr double largest_liver_ml = 3500;

// Of a result whose doubts are not known yet. Of each seed its brightness, and whether anything grew from it.
[[nodiscard]] std::vector<GrowResult::Doubt> doubts_about(const GrowResult& result,
                                                          const std::vector<double>& seed_brightness,
                                                          const std::vector<bool>& holds_seed);

}  // namespace glisson::segmentation
