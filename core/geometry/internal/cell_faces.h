#pragma once
// A tetrahedron by its corners, and its faces by theirs. Face i lies opposite corner i. It is seen counter-clockwise
// from outside of a cell whose volume is positive.

#include <array>
#include <Eigen/Core>

namespace glisson::geometry {

using CellCorners = std::array<Eigen::Vector3d, 4>;
inline constexpr std::array<std::array<int, 3>, 4> faces_of_cell{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace glisson::geometry
