#include "mechanics/scenario/rigid_tool.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

// The nearest place of a triangle to a point (Ericson, Real-Time Collision Detection, 5.1.5), as barycentrics.
Vector3d nearest_in(const Triangle& t, const Vector3d& p);

// The nearest places of two segments, as shares of their lengths (the same, 5.1.9).
std::array<double, 2> nearest_between(const Vector3d& p0, const Vector3d& p1, const Vector3d& q0, const Vector3d& q1);

Vector3d at(const Triangle& t, const Vector3d& b) { return b[0] * t[0] + b[1] * t[1] + b[2] * t[2]; }

}  // namespace

ToolShape palpation_probe(double radius_mm) { return {{Vector3d::Zero(), Vector3d::Zero(), radius_mm}}; }

ToolShape nathanson_retractor() {
  const Vector3d corners[] = {{-25, -20, 0}, {-30, 15, 0}, {-12, 35, 0}, {12, 35, 0}, {30, 15, 0}, {25, -20, 0}};
  ToolShape shape;
  for (std::size_t i = 0; i + 1 < std::size(corners); ++i) shape.push_back({corners[i], corners[i + 1], 3.0});
  return shape;
}

Pose pose_towards(const Vector3d& position_mm, const Vector3d& direction) {
  Pose pose;
  pose.position_mm = position_mm;
  const Vector3d forward = direction.normalized(), across = forward.unitOrthogonal();
  pose.rotation << across, forward.cross(across), forward;
  return pose;
}

ToolShape placed(const ToolShape& shape, const Pose& pose) {
  ToolShape moved = shape;
  for (Rod& rod : moved) {
    rod.from_mm = pose.rotation * rod.from_mm + pose.position_mm;
    rod.to_mm = pose.rotation * rod.to_mm + pose.position_mm;
  }
  return moved;
}

Result<void> check_tool(const ToolShape& shape, const Pose& pose) {
  const bool turns = pose.rotation.allFinite() && pose.position_mm.allFinite() &&
                     (pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6 &&
                     pose.rotation.determinant() > 0;
  const bool solid = !shape.empty() && std::all_of(shape.begin(), shape.end(), [](const Rod& rod) {
    return rod.from_mm.allFinite() && rod.to_mm.allFinite() && std::isfinite(rod.radius_mm) && rod.radius_mm > 0;
  });
  if (turns && solid) return {};
  return failure("tool-invalid",
                 GLISSON_TEXT("A tool needs rods with finite ends and a radius above zero, and a pose that turns and "
                              "moves it."));
}

Nearest nearest_of(const Rod& rod, const Triangle& triangle) {
  Nearest best{rod.from_mm, nearest_in(triangle, rod.from_mm), 0};
  best.distance_mm = (at(triangle, best.barycentric) - rod.from_mm).norm();
  const auto offer = [&](const Vector3d& on_axis, const Vector3d& barycentric) {
    const double distance = (at(triangle, barycentric) - on_axis).norm();
    if (distance < best.distance_mm) best = {on_axis, barycentric, distance};
  };
  const Vector3d axis = rod.to_mm - rod.from_mm;
  if (axis.squaredNorm() == 0) return best;
  offer(rod.to_mm, nearest_in(triangle, rod.to_mm));
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const auto [s, t] = nearest_between(rod.from_mm, rod.to_mm, triangle[i], triangle[next]);
    Vector3d barycentric = Vector3d::Zero();
    barycentric[i] = 1.0 - t;
    barycentric[next] = t;
    offer(rod.from_mm + s * axis, barycentric);
  }
  // Pierced: the axis crosses the plane inside the triangle.
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double along = axis.dot(normal);
  if (along != 0) {
    const double s = (triangle[0] - rod.from_mm).dot(normal) / along;
    if (s >= 0 && s <= 1) {
      const Vector3d crossing = rod.from_mm + s * axis;
      const Vector3d barycentric = nearest_in(triangle, crossing);
      if ((at(triangle, barycentric) - crossing).norm() < 1e-9 * axis.norm()) return {crossing, barycentric, 0};
    }
  }
  return best;
}

namespace {

Vector3d nearest_in(const Triangle& t, const Vector3d& p) {
  const Vector3d ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vector3d bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vector3d cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

std::array<double, 2> nearest_between(const Vector3d& p0, const Vector3d& p1, const Vector3d& q0, const Vector3d& q1) {
  const Vector3d d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const auto share = [](double value) { return std::clamp(value, 0.0, 1.0); };
  if (e == 0) return {share(a > 0 ? -c / a : 0.0), 0.0};
  const double denominator = a * e - b * b;
  double s = denominator > 1e-12 * a * e ? share((b * f - c * e) / denominator) : 0.5;
  const double t = share((b * s + f) / e);
  s = share(a > 0 ? (b * t - c) / a : 0.0);
  return {s, t};
}

}  // namespace
}  // namespace glisson::mechanics
