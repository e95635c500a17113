#include "closedloop/palpation/internal/frame.h"

#include <cmath>
#include <Eigen/Geometry>

namespace glisson::closedloop {
namespace {

constexpr double radians_per_degree = 0.017453292519943295;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

Eigen::Matrix3d rotation(const Eigen::Vector3d& rotation_deg) {
  const double angle = radians_per_degree * rotation_deg.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_deg.normalized()).toRotationMatrix();
}

// dR/dv_i = [J_l e_i]x R, J_l the left Jacobian of the rotation group (e.g. J. Sola et al. 2018, A micro Lie theory).
std::array<Eigen::Matrix3d, 3> rotation_derivatives(const Eigen::Vector3d& rotation_deg) {
  const double angle = radians_per_degree * rotation_deg.norm();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  if (angle > 1e-8) {
    const Eigen::Vector3d axis = rotation_deg.normalized();
    jacobian = std::sin(angle) / angle * Eigen::Matrix3d::Identity() +
               (1 - std::sin(angle) / angle) * axis * axis.transpose() +
               (1 - std::cos(angle)) / angle * cross_matrix(axis);
  }
  const Eigen::Matrix3d turn = rotation(rotation_deg);
  std::array<Eigen::Matrix3d, 3> derivatives;
  for (int i = 0; i < 3; ++i) {
    derivatives[static_cast<std::size_t>(i)] = radians_per_degree * cross_matrix(jacobian.col(i)) * turn;
  }
  return derivatives;
}

}  // namespace glisson::closedloop
