#include "base/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson {

std::uint64_t mixed(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed * 0xd1342543de82ef95ULL + (index + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double uniform(std::uint64_t seed, std::uint64_t index) {
  return (static_cast<double>(mixed(seed, index) >> 11) + 0.5) * 0x1p-53;
}

Eigen::Vector2d normal_pair(std::uint64_t seed, std::uint64_t index) {
  const double radius = std::sqrt(-2 * std::log(uniform(seed, 2 * index)));
  const double angle = 2 * std::numbers::pi * uniform(seed, 2 * index + 1);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double smooth_noise(std::uint64_t seed, const Eigen::Vector3d& position_mm, double length_mm) {
  const Eigen::Array3d scaled = position_mm.array() / length_mm;
  const Eigen::Array3d corner = scaled.floor();
  const Eigen::Array3d t = scaled - corner;
  const Eigen::Array3d blend = t * t * t * (t * (6 * t - 15) + 10);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const Eigen::Array3d step(c & 1, (c >> 1) & 1, c >> 2);
    const Eigen::Array3d node = corner + step;
    std::uint64_t index = 0;
    for (const double coordinate : node) {
      index =
          (index << 21) | (static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate) + (1 << 20)) & 0x1fffff);
    }
    const std::uint64_t bits = mixed(seed, index);
    const auto part = [&](int shift) { return static_cast<double>((bits >> shift) & 0xffff) / 32767.5 - 1; };
    const Eigen::Array3d gradient(part(0), part(16), part(32));
    sum += (step * blend + (1 - step) * (1 - blend)).prod() * (gradient * (t - step)).sum();
  }
  return std::clamp(1.55 * sum, -1.0, 1.0);
}

}  // namespace glisson
