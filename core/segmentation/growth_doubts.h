#pragma once
// Why what has grown may not be the liver: said beside it, never in its place.

#include <vector>

#include "segmentation/grow.h"

namespace glisson::segmentation {

// Of a result whose doubts are not known yet. Of each seed its brightness, and whether anything grew from it.
[[nodiscard]] std::vector<GrowResult::Doubt> doubts_about(const GrowResult& result,
                                                          const std::vector<double>& seed_brightness,
                                                          const std::vector<bool>& holds_seed);

}  // namespace glisson::segmentation
