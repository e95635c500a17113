#pragma once
// Rotations spread evenly, and how far two poses lie apart.

#include <Eigen/Geometry>
#include <vector>

namespace glisson::guidance {

// Where the line of sight points in the organ (48 directions, Fibonacci's lattice), and 12 turns about it.
[[nodiscard]] std::vector<Eigen::Matrix3d> even_rotations();

// At least in one of both.
struct Apart {
  double mm = 0;  // at the organ's middle
  double deg = 0;
};
[[nodiscard]] bool lie_apart(const Eigen::Isometry3d& pose, const Eigen::Isometry3d& other,
                             const Eigen::Vector3d& middle_mm, const Apart& apart);

}  // namespace glisson::guidance
