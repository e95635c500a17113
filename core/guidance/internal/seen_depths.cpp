#include "guidance/internal/seen_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int cells = 40;                        // in each direction of the cloud's rectangle
constexpr std::size_t min_picture_points = 500;  // of a picture: one in three cells
constexpr double nearest_mm = 1;                 // to the camera
constexpr double nearest_organ_mm = 5;
constexpr double before_mm = 15;  // a deformed organ may lie nearer by less

constexpr std::size_t index(int x, int y) { return static_cast<std::size_t>(y * cells + x); }
Vector2d on_picture(const Vector3d& point) { return point.head<2>() / point.z(); }

// Cells from..to of one axis whose middles lie within [low, high], both in cells.
struct Range {
  int from = 0, to = -1;
};
Range middles_within(double low, double high) {
  return {static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, 1.0 * cells))),
          static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, cells - 1.0)))};
}

}  // namespace

SeenDepths::SeenDepths(const std::vector<Vector3d>& cloud_mm)
    : depth_mm_(static_cast<std::size_t>(cells * cells), 0.0), is_near_seen_(depth_mm_.size(), 0) {
  if (cloud_mm.size() < min_picture_points) return;
  if (!std::all_of(cloud_mm.begin(), cloud_mm.end(), [](const Vector3d& p) { return p.z() > nearest_mm; })) return;
  Vector2d max = on_picture(cloud_mm.front());
  min_ = max;
  for (const Vector3d& point : cloud_mm) {
    min_ = min_.cwiseMin(on_picture(point));
    max = max.cwiseMax(on_picture(point));
  }
  cell_ = (max - min_) / cells;
  is_picture_ = cell_.minCoeff() > 0 && cell_.allFinite();
  if (!is_picture_) return;
  for (const Vector3d& point : cloud_mm) {
    const Vector2d at = (on_picture(point) - min_).cwiseQuotient(cell_);
    double& depth =
        depth_mm_[index(std::min(static_cast<int>(at.x()), cells - 1), std::min(static_cast<int>(at.y()), cells - 1))];
    depth = depth == 0 ? point.z() : std::min(depth, point.z());
  }
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      if (depth_mm_[index(x, y)] == 0) continue;
      ++seen_cells_;
      for (int ny = std::max(0, y - 1); ny <= std::min(cells - 1, y + 1); ++ny) {
        for (int nx = std::max(0, x - 1); nx <= std::min(cells - 1, x + 1); ++nx) is_near_seen_[index(nx, ny)] = 1;
      }
    }
  }
}

// The nearest depth of the sides that face the camera, at the middle of each cell; infinity where there is none.
std::vector<double> SeenDepths::depths_of(const geometry::Surface& organ, const Isometry3d& pose) const {
  std::vector<double> depths(depth_mm_.size(), std::numeric_limits<double>::infinity());
  std::vector<Vector3d> at_mm;
  at_mm.reserve(organ.points_mm.size());
  for (const Vector3d& point : organ.points_mm) at_mm.push_back(pose * point);
  for (const auto& triangle : organ.triangles) {
    const Vector3d& a = at_mm[static_cast<std::size_t>(triangle[0])];
    const Vector3d& b = at_mm[static_cast<std::size_t>(triangle[1])];
    const Vector3d& c = at_mm[static_cast<std::size_t>(triangle[2])];
    if (std::min({a.z(), b.z(), c.z()}) < nearest_organ_mm || (b - a).cross(c - a).dot(a) > 0) continue;
    const auto in_cells = [&](const Vector3d& p) -> Vector2d { return (on_picture(p) - min_).cwiseQuotient(cell_); };
    const Vector2d corner = in_cells(a), ab = in_cells(b) - corner, ac = in_cells(c) - corner;
    const double determinant = ab.x() * ac.y() - ab.y() * ac.x();
    if (determinant == 0) continue;
    const Vector2d low = corner + Vector2d::Zero().cwiseMin(ab).cwiseMin(ac);
    const Vector2d high = corner + Vector2d::Zero().cwiseMax(ab).cwiseMax(ac);
    const Range across = middles_within(low.x(), high.x()), down = middles_within(low.y(), high.y());
    for (int y = down.from; y <= down.to; ++y) {
      for (int x = across.from; x <= across.to; ++x) {
        const Vector2d p = Vector2d(x + 0.5, y + 0.5) - corner;
        const double v = (p.x() * ac.y() - p.y() * ac.x()) / determinant;
        const double w = (ab.x() * p.y() - ab.y() * p.x()) / determinant;
        if (v < 0 || w < 0 || v + w > 1) continue;
        // The inverse of depth is linear over a picture.
        const double depth = 1 / ((1 - v - w) / a.z() + v / b.z() + w / c.z());
        depths[index(x, y)] = std::min(depths[index(x, y)], depth);
      }
    }
  }
  return depths;
}

SeenDepths::Contradiction SeenDepths::contradiction(const geometry::Surface& organ, const Isometry3d& pose) const {
  const std::vector<double> depths = depths_of(organ, pose);
  Contradiction found;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (std::isinf(depths[i])) continue;
    if (depth_mm_[i] > 0) {
      found.before += depths[i] < depth_mm_[i] - before_mm ? 1 : 0;
    } else if (is_near_seen_[i] == 0) {
      found.unseen += 1;
    }
  }
  found.before /= seen_cells_;
  found.unseen /= seen_cells_;
  return found;
}

}  // namespace glisson::guidance
