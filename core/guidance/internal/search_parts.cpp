#include "guidance/internal/search_parts.h"

#include <cmath>
#include <numbers>

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector3d;

std::vector<Eigen::Matrix3d> even_rotations() {
  constexpr int directions = 48, turns = 12;
  std::vector<Eigen::Matrix3d> rotations;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int d = 0; d < directions; ++d) {
    const double z = 1 - (2 * d + 1.0) / directions, across = std::sqrt(1 - z * z);
    const Vector3d sight(across * std::cos(golden * d), across * std::sin(golden * d), z);
    const Eigen::Quaterniond onto = Eigen::Quaterniond::FromTwoVectors(sight, Vector3d::UnitZ());
    for (int t = 0; t < turns; ++t) {
      const Eigen::AngleAxisd about(2 * std::numbers::pi * t / turns, Vector3d::UnitZ());
      rotations.emplace_back(about.toRotationMatrix() * onto.toRotationMatrix());
    }
  }
  return rotations;
}

bool lie_apart(const Isometry3d& pose, const Isometry3d& other, const Vector3d& middle_mm, const Apart& apart) {
  const double turn = Eigen::AngleAxisd(pose.linear().transpose() * other.linear()).angle();
  return (pose * middle_mm - other * middle_mm).norm() > apart.mm || turn * 180 / std::numbers::pi > apart.deg;
}

Isometry3d moved_about(const Isometry3d& pose, const Vector3d& about_mm, const Eigen::Matrix<double, 6, 1>& step) {
  const double angle = step.tail<3>().norm();
  Isometry3d moved = Isometry3d::Identity();
  moved.translate(about_mm + step.head<3>());
  if (angle > 0) moved.rotate(Eigen::AngleAxisd(angle, step.tail<3>() / angle));
  moved.translate(-about_mm);
  return moved * pose;
}

}  // namespace glisson::guidance
