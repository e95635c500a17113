#pragma once
// Delaunay triangulation in the plane.

#include <array>
#include <Eigen/Core>
#include <vector>

namespace glisson::geometry {

// Counter-clockwise triangles that fill the points' convex hull. Of points that coincide only one is used; points all
// on one line give none. All coordinates must be finite.
[[nodiscard]] std::vector<std::array<int, 3>> delaunay_triangles(const std::vector<Eigen::Vector2d>& points);

}  // namespace glisson::geometry
