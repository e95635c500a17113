#include "mechanics/cutting/cut_strip.h"

#include <algorithm>
#include <array>
#include <vector>

namespace glisson::mechanics {

using Eigen::Vector3d;

bool lies_within(const CutStrip& strip, const Vector3d& place_mm) {
  if (strip.surface.is_swept()) return CutSoFar({strip}).covers(place_mm);
  const Vector3d way_mm = strip.to_mm - strip.from_mm;
  const double at = (place_mm - strip.from_mm).dot(way_mm) / way_mm.squaredNorm();
  return at >= 0 && at <= 1;
}

CutSoFar::CutSoFar(const std::vector<CutStrip>& strips) : strips_(strips) {
  if (strips_.empty() || !strips_.front().surface.is_swept()) return;
  for (const CutStrip& strip : strips_) {
    const double from_mm = strip.surface.on_line(strip.from_mm).along_mm;
    const double to_mm = strip.surface.on_line(strip.to_mm).along_mm;
    along_mm_.emplace_back(std::min(from_mm, to_mm), std::max(from_mm, to_mm));
  }
  std::sort(along_mm_.begin(), along_mm_.end());
  std::size_t last = 0;
  for (const auto& [from_mm, to_mm] : along_mm_) {
    if (from_mm > along_mm_[last].second) along_mm_[++last] = {from_mm, to_mm};
    along_mm_[last].second = std::max(along_mm_[last].second, to_mm);
  }
  along_mm_.resize(last + 1);
  strips_ = {strips.back()};
}

bool CutSoFar::covers(const Vector3d& place_mm) const {
  if (along_mm_.empty()) {
    return std::any_of(strips_.begin(), strips_.end(),
                       [&](const CutStrip& strip) { return lies_within(strip, place_mm); });
  }
  const geometry::CutSurface& surface = strips_.front().surface;
  const geometry::CutSurface::OnLine at = surface.on_line(place_mm);
  if (std::abs(at.deep_mm) > surface.into_mm().norm()) return false;
  return std::any_of(along_mm_.begin(), along_mm_.end(),
                     [&](const auto& part) { return at.along_mm >= part.first && at.along_mm <= part.second; });
}

bool crosses(const CutStrip& strip, const geometry::Surface& surface) {
  const CutSoFar opened({strip});
  std::vector<double> height_mm;
  for (const Vector3d& point : surface.points_mm) height_mm.push_back(strip.surface.height_mm(point));
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const std::array<int, 3>& triangle) {
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(triangle[i]), b = static_cast<std::size_t>(triangle[(i + 1) % 3]);
      if ((height_mm[a] > 0) == (height_mm[b] > 0)) continue;
      const double share = height_mm[a] / (height_mm[a] - height_mm[b]);
      if (opened.covers((1.0 - share) * surface.points_mm[a] + share * surface.points_mm[b])) return true;
    }
    return false;
  });
}

}  // namespace glisson::mechanics
