#include "guidance/hand_pose.h"

#include <algorithm>
#include <numbers>

namespace glisson::guidance {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Isometry3d turned_about(const Isometry3d& pose, const Vector3d& about_mm, const Eigen::Matrix3d& rotation) {
  const Vector3d fixed = pose * about_mm;
  Isometry3d turned = Isometry3d::Identity();
  turned.linear() = rotation * pose.linear();
  turned.translation() = fixed - turned.linear() * about_mm;
  return turned;
}

Isometry3d moved_to(const Isometry3d& pose, const Vector3d& about_mm, const Vector3d& to_mm) {
  Isometry3d moved = pose;
  moved.pretranslate(to_mm - pose * about_mm);
  return moved;
}

}  // namespace

Isometry3d pose_before_camera(const vision::Camera& camera, int width, int height, const geometry::Surface& organ) {
  const Vector3d away = Vector3d(0, 0.96, 0.28).normalized();  // to the back, and to the head
  Isometry3d pose = Isometry3d::Identity();
  pose.linear().row(0) = Vector3d::UnitX();
  pose.linear().row(2) = away;
  pose.linear().row(1) = away.cross(Vector3d::UnitX());
  const geometry::Box box = geometry::bounding_box(organ.points_mm);
  const Vector3d middle = box.center_mm();
  const Vector3d size_mm = box.max_mm - box.min_mm;
  const double distance_mm =  // of the middle, half the depth behind what is three quarters of the picture wide
      camera.matrix(0, 0) * size_mm.x() / (0.75 * width) + 0.5 * size_mm.dot(away.cwiseAbs());
  const Vector3d at_px((width / 2.0 - camera.matrix(0, 2)) / camera.matrix(0, 0),
                       (height / 2.0 - camera.matrix(1, 2)) / camera.matrix(1, 1), 1);
  return moved_to(pose, middle, distance_mm * at_px);
}

Isometry3d shifted(const Isometry3d& pose, const Vector3d& about_mm, const vision::Camera& camera,
                   const Eigen::Vector2d& by_px) {
  const Vector3d at = pose * about_mm;
  const Vector3d by_mm(by_px.x() * at.z() / camera.matrix(0, 0), by_px.y() * at.z() / camera.matrix(1, 1), 0);
  return moved_to(pose, about_mm, at + by_mm);
}

Isometry3d turned(const Isometry3d& pose, const Vector3d& about_mm, double right_deg, double down_deg) {
  // The front is nearer than what it is turned about: it goes to the right about -y, down about +x.
  const Eigen::Matrix3d rotation =
      (AngleAxisd(radians(-right_deg), Vector3d::UnitY()) * AngleAxisd(radians(down_deg), Vector3d::UnitX()))
          .toRotationMatrix();
  return turned_about(pose, about_mm, rotation);
}

Isometry3d rolled(const Isometry3d& pose, const Vector3d& about_mm, double clockwise_deg) {
  return turned_about(pose, about_mm, AngleAxisd(radians(clockwise_deg), Vector3d::UnitZ()).toRotationMatrix());
}

Isometry3d moved_in_depth(const Isometry3d& pose, const Vector3d& about_mm, double factor) {
  constexpr double nearest_mm = 20;
  const Vector3d at = pose * about_mm;
  if (at.z() <= 0) return pose;
  return moved_to(pose, about_mm, at * std::max(factor, nearest_mm / at.z()));
}

ElasticPlacement rigid_placement(const Isometry3d& pose, const geometry::TetMesh& mesh) {
  ElasticPlacement placement;
  placement.converged = true;
  placement.pose = pose;
  placement.displacement_mm.assign(mesh.points_mm.size(), Vector3d::Zero());
  return placement;
}

}  // namespace glisson::guidance
