#include "resect/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr double radians_per_degree = std::numbers::pi / 180;

}  // namespace

Vector3d CutPlane::normal() const {
  const double turn = turn_deg * radians_per_degree, tilt = tilt_deg * radians_per_degree;
  return {std::cos(tilt) * std::cos(turn), std::cos(tilt) * std::sin(turn), std::sin(tilt)};
}

void CutPlane::put(const Vector3d& through_mm, const Vector3d& towards) {
  const Vector3d unit = towards.normalized();
  tilt_deg = std::asin(std::clamp(unit.z(), -1.0, 1.0)) / radians_per_degree;
  // Straight up, every turn is the same.
  if (unit.head<2>().norm() > 1e-9) turn_deg = std::atan2(unit.y(), unit.x()) / radians_per_degree;
  shift_mm = (through_mm - middle_mm).dot(normal());
}

LineInSlice line_in_slice(const CutPlane& plane, const Vector3d& slice_point_mm, const Vector3d& slice_normal) {
  constexpr double nearly_parallel = 0.1;
  const Vector3d normal = plane.normal();
  const Vector3d across = normal.cross(slice_normal);
  LineInSlice line{plane.point_mm(), Vector3d::Zero()};
  if (across.norm() < nearly_parallel) return line;
  // Within the plane, towards the slice.
  const Vector3d towards = (slice_normal - slice_normal.dot(normal) * normal).normalized();
  line.at_mm += slice_normal.dot(slice_point_mm - line.at_mm) / slice_normal.dot(towards) * towards;
  line.along = across.normalized();
  return line;
}

std::array<Vector3d, 4> corners_mm(const CutPlane& plane, double half_side_mm) {
  const Vector3d normal = plane.normal();
  // Upright, where the plane is not level.
  const Vector3d up = std::abs(normal.z()) < 0.95 ? Vector3d::UnitZ() : Vector3d(-Vector3d::UnitY());
  const Vector3d right = up.cross(normal).normalized() * half_side_mm;
  const Vector3d above = normal.cross(right);
  const Vector3d at = plane.point_mm();
  return {at - right - above, at + right - above, at + right + above, at - right + above};
}

geometry::Surface square_of(const CutPlane& plane, double half_side_mm) {
  const auto corners = corners_mm(plane, half_side_mm);
  geometry::Surface square;
  square.points_mm.assign(corners.begin(), corners.end());
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  return square;
}

}  // namespace glisson::widgets
