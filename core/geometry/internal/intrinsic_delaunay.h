#pragma once
// The intrinsic Delaunay triangulation of a surface: the same surface and points, other triangles drawn on it, whose
// edges run straight along it. Cotangents of its edges are never negative, however thin the surface's own triangles
// are. By flips of edges, of which lengths alone must be known (Fisher, Springborn, Schroeder and Bobenko 2007,
// Computing 81:199-213). Two of its corners may be one point.

#include <array>
#include <vector>

#include "geometry/surface.h"

namespace glisson::geometry {

struct IntrinsicTriangle {
  std::array<int, 3> points;
  std::array<double, 3> lengths_mm;  // of the edges from corner k to corner k + 1
};

// The surface must be a manifold, with or without a border (at most two triangles an edge, turned alike).
[[nodiscard]] std::vector<IntrinsicTriangle> intrinsic_delaunay(const Surface& surface);

// The third corner, where the first is at 0 and the second at (length_mm, 0).
[[nodiscard]] Eigen::Vector2d third_corner_mm(double length_mm, double from_second_mm, double to_first_mm);

}  // namespace glisson::geometry
