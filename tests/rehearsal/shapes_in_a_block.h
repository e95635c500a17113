#pragma once
// A block of 80 x 60 x 60 mm from the origin, and balls and tubes in it: planned resections of known numbers.

#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <numbers>

#include "mechanics/bodies.h"

namespace glisson::rehearsal::test {

using Eigen::Vector3d;

inline geometry::TetMesh block() {
  auto mesh = mechanics::test::box(8, 6, 6, {80, 60, 60});
  mechanics::test::disturb_inner_points(mesh, 2.0);
  return mesh;
}

// A ball, or a tube along a direction, of fine triangles.
inline geometry::Surface grid(int rows, int columns, const std::function<Vector3d(double, double)>& at) {
  geometry::Surface surface;
  for (int i = 0; i <= rows; ++i) {
    for (int k = 0; k < columns; ++k) surface.points_mm.push_back(at(double(i) / rows, double(k) / columns));
  }
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const int a = i * columns + k, b = i * columns + (k + 1) % columns;
      surface.triangles.push_back({a, b, b + columns});
      surface.triangles.push_back({a, b + columns, a + columns});
    }
  }
  return surface;
}

inline geometry::Surface ball(const Vector3d& center, double radius) {
  return grid(40, 60, [&](double u, double v) -> Vector3d {
    const double polar = (1e-3 + u * (1 - 2e-3)) * std::numbers::pi, around = 2 * std::numbers::pi * v;
    return center +
           radius * Vector3d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
  });
}

inline geometry::Surface tube(const Vector3d& from, const Vector3d& to, double radius) {
  const Vector3d axis = (to - from).normalized(), first = axis.unitOrthogonal(), second = axis.cross(first);
  return grid(40, 60, [&](double u, double v) -> Vector3d {
    const double around = 2 * std::numbers::pi * v;
    return from + u * (to - from) + radius * (std::cos(around) * first + std::sin(around) * second);
  });
}

}  // namespace glisson::rehearsal::test
