#include "mechanics/bearing.h"

#include <algorithm>
#include <cmath>

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d place_of(const Bearing& bearing, const VectorXd& u_mm) {
  Vector3d at_mm = bearing.rest_mm;
  for (int i = 0; i < 3; ++i) at_mm += bearing.place.weights[i] * u_mm.segment<3>(3 * bearing.nodes[i]);
  return at_mm;
}

Gap gap_of(const Bearing& bearing, const VectorXd& u_mm) {
  const Vector3d at_mm = place_of(bearing, u_mm);
  const Vector3d axis = bearing.rod.to_mm - bearing.rod.from_mm;
  const double along = axis.squaredNorm() > 0 ? (at_mm - bearing.rod.from_mm).dot(axis) / axis.squaredNorm() : 0.0;
  const Vector3d arm = at_mm - bearing.rod.from_mm - std::clamp(along, 0.0, 1.0) * axis;
  const double distance_mm = std::max(arm.norm(), 1e-9);
  Gap gap{distance_mm - bearing.rod.radius_mm, arm / distance_mm, Matrix3d::Identity()};
  gap.bend -= gap.normal * gap.normal.transpose();
  if (along > 0 && along < 1) gap.bend -= axis * axis.transpose() / axis.squaredNorm();
  gap.bend /= distance_mm;
  return gap;
}

void limit_drag(Bearing& bearing, const VectorXd& u_mm) {
  bearing.most_drag_mN = bearing.friction * bearing.force_mN;
  if (bearing.most_drag_mN == 0) return;
  bearing.normal = gap_of(bearing, u_mm).normal;
  bearing.drag_mN -= bearing.drag_mN.dot(bearing.normal) * bearing.normal;
}

Drag drag_of(const Bearing& bearing, double k_mN_mm, const VectorXd& u_mm) {
  if (bearing.most_drag_mN == 0) return {Vector3d::Zero(), Matrix3d::Zero(), 0.0, true};
  const Matrix3d tangential = Matrix3d::Identity() - bearing.normal * bearing.normal.transpose();
  const Vector3d y = bearing.drag_mN - k_mN_mm * tangential * (place_of(bearing, u_mm) - bearing.from_mm);
  const double most = bearing.most_drag_mN, size = y.norm(), known = bearing.drag_mN.squaredNorm();
  if (size <= most) return {y, k_mN_mm * tangential, (size * size - known) / (2 * k_mN_mm), false};
  const Vector3d way = y / size;
  return {most * way, k_mN_mm * most / size * (tangential - way * way.transpose()),
          (2 * most * size - most * most - known) / (2 * k_mN_mm), true};
}

}  // namespace glisson::mechanics
