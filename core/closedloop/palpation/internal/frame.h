#pragma once
// How a camera's frame may be turned against the specimen's: rotations by a vector in degrees, its direction the axis
// and its length the angle.

#include <array>
#include <Eigen/Core>

namespace glisson::closedloop {

[[nodiscard]] Eigen::Matrix3d rotation(const Eigen::Vector3d& rotation_deg);
// By each component, per degree.
[[nodiscard]] std::array<Eigen::Matrix3d, 3> rotation_derivatives(const Eigen::Vector3d& rotation_deg);

}  // namespace glisson::closedloop
