#include "scene/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace glisson::scene {
namespace {

// 33 samples of each map, 0xRRGGBB, evenly from its low end to its high end; between them the colour is mixed.
using Samples = std::array<std::uint32_t, 33>;

constexpr Samples viridis_samples{
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b, 0x375b8d, 0x33638d,
    0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21918c, 0x1f978b, 0x1f9f88, 0x21a685, 0x27ad81, 0x31b57b,
    0x3dbc74, 0x4cc26c, 0x5cc863, 0x6ece58, 0x81d34d, 0x95d840, 0xaadc32, 0xc0df25, 0xd5e21a, 0xeae51a, 0xfde725};
constexpr Samples cividis_samples{
    0x00224e, 0x00285b, 0x002e6a, 0x053371, 0x1a386f, 0x273e6e, 0x32436d, 0x3b496c, 0x434e6c, 0x4b546c, 0x535a6d,
    0x5a5f6e, 0x61656f, 0x686a71, 0x6f7073, 0x767676, 0x7d7c78, 0x838179, 0x8b8778, 0x928d78, 0x9a9376, 0xa29975,
    0xaaa073, 0xb3a670, 0xbbad6d, 0xc3b369, 0xccba64, 0xd4c15f, 0xddc858, 0xe6d051, 0xefd748, 0xf8df3c, 0xfee838};
constexpr Samples magma_samples{
    0x000004, 0x030312, 0x0a0822, 0x130d34, 0x1d1147, 0x29115a, 0x36106b, 0x440f76, 0x51127c, 0x5d177f, 0x6a1c81,
    0x762181, 0x832681, 0x902a81, 0x9c2e7f, 0xaa337d, 0xb73779, 0xc23b75, 0xcf4070, 0xdb476a, 0xe55064, 0xee5b5e,
    0xf4695c, 0xf9785d, 0xfb8761, 0xfd9668, 0xfea571, 0xfeb47b, 0xfec287, 0xfed194, 0xfde0a1, 0xfceeb0, 0xfcfdbf};
constexpr Samples plasma_samples{
    0x0d0887, 0x220690, 0x310597, 0x3f049c, 0x4c02a1, 0x5901a5, 0x6600a7, 0x7201a8, 0x7e03a8, 0x8a09a5, 0x9511a1,
    0xa01a9c, 0xaa2395, 0xb32c8e, 0xbc3587, 0xc43e7f, 0xcc4778, 0xd24f71, 0xd9586a, 0xdf6263, 0xe56b5d, 0xeb7556,
    0xf07f4f, 0xf48948, 0xf89441, 0xfb9f3a, 0xfdab33, 0xfeb72d, 0xfdc328, 0xfcd025, 0xf9dd25, 0xf5eb27, 0xf0f921};

Colour unpack(std::uint32_t rgb) {
  return {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0};
}

Colour mix(const Colour& a, const Colour& b, double share_of_b) {
  const double share_of_a = 1 - share_of_b;
  return {share_of_a * a.red + share_of_b * b.red, share_of_a * a.green + share_of_b * b.green,
          share_of_a * a.blue + share_of_b * b.blue};
}

Colour sample(const Samples& samples, double fraction) {
  const double place = fraction * static_cast<double>(samples.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  return mix(unpack(samples[below]), unpack(samples[below + 1]), place - static_cast<double>(below));
}

}  // namespace

Colour colour_at(ColourMap map, double fraction) {
  const double t = std::isnan(fraction) ? 0 : std::clamp(fraction, 0.0, 1.0);
  switch (map) {
    case ColourMap::viridis: return sample(viridis_samples, t);
    case ColourMap::cividis: return sample(cividis_samples, t);
    case ColourMap::magma: return sample(magma_samples, t);
    case ColourMap::plasma: return sample(plasma_samples, t);
    case ColourMap::grey: return {t, t, t};
  }
  return {};
}

std::vector<double> round_marks(double low, double high, int wanted) {
  if (!(high > low) || wanted < 1) return {low};
  const double rough = (high - low) / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = decade * (rough / decade < 1.5 ? 1 : rough / decade < 3.5 ? 2 : rough / decade < 7.5 ? 5 : 10);
  std::vector<double> marks;
  // Counted in whole steps, so that 0.3 is 3 * 0.1 and zero is exactly zero.
  const auto last = static_cast<long>(std::floor(high / step + 1e-9));
  for (auto k = static_cast<long>(std::ceil(low / step - 1e-9)); k <= last; ++k) {
    marks.push_back(static_cast<double>(k) * step);
  }
  return marks;
}

}  // namespace glisson::scene
