#pragma once
// A triangle surface in patient coordinates (LPS, mm), with quantities on its points and triangles.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/field.h"

namespace glisson::geometry {

struct Surface {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
  Fields point_fields;
  Fields cell_fields;  // one item a triangle
};

struct Box {
  Eigen::Vector3d min_mm{0, 0, 0};
  Eigen::Vector3d max_mm{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d center_mm() const { return 0.5 * (min_mm + max_mm); }
  [[nodiscard]] double diagonal_mm() const { return (max_mm - min_mm).norm(); }
};

[[nodiscard]] Box bounding_box(const std::vector<Eigen::Vector3d>& points_mm);
[[nodiscard]] double area_mm2(const Surface& surface);

// Volume enclosed, by the divergence theorem; negative for a surface turned inside out. Meaningful only when
// watertight.
[[nodiscard]] double volume_mm3(const Surface& surface);

// Every edge is shared by exactly two triangles that run along it in opposite directions.
[[nodiscard]] bool is_watertight(const Surface& surface);

// The points where the surface touches itself or has a border: those around which the triangles are not one closed fan.
// A watertight surface without such points is a manifold.
[[nodiscard]] std::vector<int> pinched_points(const Surface& surface);

// Area-weighted unit normals, one a point; outward when the triangles are counter-clockwise from outside.
[[nodiscard]] std::vector<Eigen::Vector3d> point_normals(const Surface& surface);

// The pieces that hang together by shared points, the largest (by area) first.
[[nodiscard]] std::vector<Surface> connected_pieces(const Surface& surface);

// Refuses what no later stage can use: an index out of range, a point that is not finite, no triangles.
Result<void> check_surface(const Surface& surface);

// The mean of its points, whatever they stand for.
[[nodiscard]] Eigen::Vector3d mean_point_mm(const Surface& surface);

}  // namespace glisson::geometry
