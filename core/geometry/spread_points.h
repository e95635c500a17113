#pragma once
// A few points that stand for many.

#include <cstddef>
#include <Eigen/Core>
#include <vector>

namespace glisson::geometry {

// So many of the points, or all: from `first` on, each the farthest in space from those chosen before it (Eldar et al.
// 1997). Indices, in that order. Costs points times count.
[[nodiscard]] std::vector<std::size_t> spread_points(const std::vector<Eigen::Vector3d>& points_mm, std::size_t count,
                                                     std::size_t first = 0);

}  // namespace glisson::geometry
