#include "planning/cut.h"

#include <algorithm>
#include <cmath>

namespace glisson::planning {

using Eigen::Vector3d;

// f - 1 over the length of f's gradient, f being 1 on the surface.
double outside_mm(const AblationCut& zone, const Vector3d& place_mm) {
  const Vector3d along = zone.direction.normalized(), way_mm = place_mm - zone.center_mm;
  const Vector3d part_along_mm = way_mm.dot(along) * along, part_across_mm = way_mm - part_along_mm;
  const double a2 = zone.radius_along_mm * zone.radius_along_mm, b2 = zone.radius_across_mm * zone.radius_across_mm;
  const double f = std::sqrt(part_along_mm.squaredNorm() / a2 + part_across_mm.squaredNorm() / b2);
  if (f == 0) return -std::min(zone.radius_along_mm, zone.radius_across_mm);
  return f * (f - 1) / (part_along_mm / a2 + part_across_mm / b2).norm();
}

}  // namespace glisson::planning
