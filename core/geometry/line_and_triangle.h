#pragma once
// Where a straight line meets a triangle (Moeller and Trumbore 1997, J Graph Tools 2:21).

#include <cmath>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace glisson::geometry {

struct LineMeetsTriangle {
  double at = 0;        // lengths of the direction from the line's place, negative before it
  double b = 0, c = 0;  // weights of the second and third corner; that of the first is 1 - b - c
};

// From either side. Nothing where it passes by, or lies in the triangle's plane. One unit for all lengths.
[[nodiscard]] inline std::optional<LineMeetsTriangle> line_meets_triangle(const Eigen::Vector3d& place,
                                                                          const Eigen::Vector3d& direction,
                                                                          const Eigen::Vector3d& first,
                                                                          const Eigen::Vector3d& second,
                                                                          const Eigen::Vector3d& third) {
  const Eigen::Vector3d along_b = second - first, along_c = third - first;
  const Eigen::Vector3d across = direction.cross(along_c);
  const double determinant = along_b.dot(across);
  if (std::abs(determinant) < 1e-12) return std::nullopt;
  const Eigen::Vector3d from_first = place - first;
  const double b = from_first.dot(across) / determinant;
  if (b < 0 || b > 1) return std::nullopt;
  const Eigen::Vector3d other = from_first.cross(along_b);
  const double c = direction.dot(other) / determinant;
  if (c < 0 || b + c > 1) return std::nullopt;
  return LineMeetsTriangle{along_c.dot(other) / determinant, b, c};
}

}  // namespace glisson::geometry
