#include "scene/internal/slices.h"

#include <algorithm>
#include <cmath>

#include "scene/anatomy.h"

namespace glisson::scene {

void set_grey_window(SliceItem& slice) {
  std::vector<float> sample;
  const auto& values = slice.volume->values;
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 200000);
  for (std::size_t i = 0; i < values.size(); i += stride) {
    if (std::isfinite(values[i])) sample.push_back(values[i]);
  }
  if (sample.empty()) return;
  std::sort(sample.begin(), sample.end());
  const double low = sample[sample.size() / 50];
  const double high = sample[sample.size() - 1 - sample.size() / 200];
  slice.window_center = 0.5 * (low + high);
  slice.window_width = std::max(high - low, 1e-6);
}

MaskLine outline_of(segmentation::Structure structure) {
  constexpr double width_px = 2;
  const Colour colour = appearance_of(structure.name).colour;
  return {std::make_shared<const imaging::Mask>(std::move(structure.mask)), colour, width_px};
}

}  // namespace glisson::scene
