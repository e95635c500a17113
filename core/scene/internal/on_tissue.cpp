#include "scene/internal/on_tissue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace glisson::scene {
namespace {

// 0xRRGGBB, evenly from the low end to the high end: the most saturated colours of sRGB along a line of CIELAB from
// (33, 300 degrees) over (62, 250) to (91, 140), lightness and hue, spread evenly by CIEDE2000.
constexpr std::array<std::uint32_t, 33> samples{
    0x1339ce, 0x1243c8, 0x124cc4, 0x1254c1, 0x125cc0, 0x1364c0, 0x136cc2, 0x1474c4, 0x157bc6, 0x1683c9, 0x178acd,
    0x1892d1, 0x199ad5, 0x1aa2d8, 0x1ba9d7, 0x1bafd7, 0x1cb5d6, 0x1dbcd5, 0x1dc2d4, 0x1ec8d3, 0x1fced1, 0x1fd3cf,
    0x20d8cc, 0x20ddc9, 0x21e2c4, 0x22e7be, 0x22ecb7, 0x23f1ad, 0x23f5a3, 0x24fa96, 0x26fe86, 0x66fe86, 0x8cfe88};

double part(std::uint32_t rgb, int shift) { return ((rgb >> shift) & 0xff) / 255.0; }

}  // namespace

Colour colour_on_tissue(double fraction) {
  const double place = (std::isnan(fraction) ? 0 : std::clamp(fraction, 0.0, 1.0)) * (samples.size() - 1.0);
  const auto below = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const double above = place - static_cast<double>(below);
  const auto mixed = [&](int shift) {
    return (1 - above) * part(samples[below], shift) + above * part(samples[below + 1], shift);
  };
  return {mixed(16), mixed(8), mixed(0)};
}

}  // namespace glisson::scene
