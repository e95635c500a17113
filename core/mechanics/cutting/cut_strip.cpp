#include "mechanics/cutting/cut_strip.h"

#include <algorithm>
#include <array>
#include <vector>

namespace glisson::mechanics {

using Eigen::Vector3d;

bool lies_within(const CutStrip& strip, const Vector3d& place_mm) {
  const Vector3d way_mm = strip.to_mm - strip.from_mm;
  const double at = (place_mm - strip.from_mm).dot(way_mm) / way_mm.squaredNorm();
  return at >= 0 && at <= 1;
}

bool crosses(const CutStrip& strip, const geometry::Surface& surface) {
  std::vector<double> height_mm;
  for (const Vector3d& point : surface.points_mm) height_mm.push_back(strip.surface.height_mm(point));
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const std::array<int, 3>& triangle) {
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(triangle[i]), b = static_cast<std::size_t>(triangle[(i + 1) % 3]);
      if ((height_mm[a] > 0) == (height_mm[b] > 0)) continue;
      const double share = height_mm[a] / (height_mm[a] - height_mm[b]);
      if (lies_within(strip, (1.0 - share) * surface.points_mm[a] + share * surface.points_mm[b])) return true;
    }
    return false;
  });
}

}  // namespace glisson::mechanics
