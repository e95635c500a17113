#include "widgets/resect/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr double radians_per_degree = std::numbers::pi / 180;

// Of the plane about its point.
std::vector<Vector3d> square(const CutPlane& plane, double half_side_mm) {
  const Vector3d normal = plane.normal();
  // Upright, where the plane is not level.
  const Vector3d up = std::abs(normal.z()) < 0.95 ? Vector3d::UnitZ() : Vector3d(-Vector3d::UnitY());
  const Vector3d right = up.cross(normal).normalized() * half_side_mm;
  const Vector3d above = normal.cross(right);
  const Vector3d at = plane.point_mm();
  return {at - right - above, at + right - above, at + right + above, at - right + above};
}

// What of a convex polygon has sign * coordinate up to a limit (Sutherland and Hodgman).
std::vector<Vector3d> cut_off(const std::vector<Vector3d>& corners_mm, Eigen::Index axis, double sign,
                              double maximum_mm) {
  constexpr double same_mm = 1e-6;
  std::vector<Vector3d> left_mm;
  const auto add = [&](const Vector3d& corner_mm) {
    if (left_mm.empty() || (left_mm.back() - corner_mm).norm() > same_mm) left_mm.push_back(corner_mm);
  };
  for (std::size_t k = 0; k < corners_mm.size(); ++k) {
    const Vector3d& from_mm = corners_mm[k];
    const Vector3d& to_mm = corners_mm[(k + 1) % corners_mm.size()];
    const double from_beyond = sign * from_mm[axis] - maximum_mm, to_beyond = sign * to_mm[axis] - maximum_mm;
    if (from_beyond <= 0) add(from_mm);
    if ((from_beyond < 0 && to_beyond > 0) || (from_beyond > 0 && to_beyond < 0))
      add(from_mm + from_beyond / (from_beyond - to_beyond) * (to_mm - from_mm));
  }
  if (left_mm.size() > 1 && (left_mm.front() - left_mm.back()).norm() <= same_mm) left_mm.pop_back();
  return left_mm;
}

void halve_longest_edge(std::vector<Vector3d>& corners_mm) {
  const auto after = [&](std::size_t k) -> const Vector3d& { return corners_mm[(k + 1) % corners_mm.size()]; };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < corners_mm.size(); ++k) {
    if ((after(k) - corners_mm[k]).norm() > (after(longest) - corners_mm[longest]).norm()) longest = k;
  }
  const Vector3d middle_mm = 0.5 * (corners_mm[longest] + after(longest));
  corners_mm.insert(corners_mm.begin() + static_cast<std::ptrdiff_t>(longest) + 1, middle_mm);
}

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

std::array<Vector3d, 7> points_within(const CutPlane& plane, const geometry::Box& box) {
  constexpr double small_mm = 12;
  std::vector<Vector3d> corners_mm = square(plane, 2 * box.diagonal_mm());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    corners_mm = cut_off(corners_mm, axis, 1, box.max_mm[axis]);
    corners_mm = cut_off(corners_mm, axis, -1, -box.min_mm[axis]);
  }
  if (corners_mm.size() < 3) corners_mm = square(plane, small_mm);
  while (corners_mm.size() < 6) halve_longest_edge(corners_mm);
  corners_mm.resize(6);  // a plane cuts no more of a box's edges
  std::array<Vector3d, 7> points_mm;
  points_mm[0].setZero();
  for (std::size_t k = 0; k < 6; ++k) {
    points_mm[k + 1] = corners_mm[k];
    points_mm[0] += corners_mm[k] / 6;
  }
  return points_mm;
}

geometry::Surface part_within(const CutPlane& plane, const geometry::Box& box) {
  const auto points_mm = points_within(plane, box);
  geometry::Surface part;
  part.points_mm.assign(points_mm.begin(), points_mm.end());
  for (int k = 0; k < 6; ++k) part.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
  return part;
}

}  // namespace glisson::widgets
