#include "hardware/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "base/noise.h"
#include "hardware/internal/device_figures.h"

namespace glisson::hardware {
namespace {

bool may_vary(const FigureSlot& slot, const Figure& figure) {
  static const std::set<std::string> fixed{"throttle_C", "tile_nodes", "rate_exponent", "capacity_per_C"};
  return !fixed.contains(slot.name) && !(slot.ideal && figure.value == *slot.ideal);
}

}  // namespace

double relative_sd(Source source) {
  switch (source) {
    case Source::measured:
    case Source::dissertation: return 0.05;
    case Source::computed: return 0.1;
    case Source::assumed: return 0.3;
  }
  return 0.3;
}

Device drawn(const Device& device, std::uint64_t draw) {
  Device other = device;
  std::uint64_t index = 0;
  for (const FigureSlot& slot : figure_slots()) {
    const double normal = normal_pair(draw, index++)[0];
    Figure& figure = slot.of(other);
    if (!may_vary(slot, figure)) continue;
    figure.value = std::clamp(figure.value * std::exp(relative_sd(figure.source) * normal), slot.minimum, slot.maximum);
  }
  const auto normals = normal_pair(draw, index);
  for (MeasuredProduct& product : other.kernel.measured) {
    product.seconds *= std::exp(relative_sd(Source::measured) * normals[0]);
    if (product.joules) *product.joules *= std::exp(relative_sd(Source::measured) * normals[1]);
  }
  return other;
}

}  // namespace glisson::hardware
