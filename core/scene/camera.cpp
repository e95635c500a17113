#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace glisson::scene {
namespace {

Eigen::Vector3d sight_of(PatientView view) {
  switch (view) {
    case PatientView::anterior: return {0, 1, 0};
    case PatientView::posterior: return {0, -1, 0};
    case PatientView::left: return {-1, 0, 0};
    case PatientView::right: return {1, 0, 0};
    case PatientView::superior: return {0, 0, -1};
    case PatientView::inferior: return {0, 0, 1};
    case PatientView::surgeon: return Eigen::Vector3d(0.35, 0.85, 0.40).normalized();
  }
  return {0, 1, 0};
}

// The head is up, except when looking along the body: then the front of the body is.
Eigen::Vector3d up_for(const Eigen::Vector3d& sight) {
  const Eigen::Vector3d wanted = std::abs(sight.z()) > 0.9 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
  return (wanted - wanted.dot(sight) * sight).normalized();
}

// How far the box reaches from its centre along a direction.
double half_extent_mm(const geometry::Box& box, const Eigen::Vector3d& direction) {
  return 0.5 * (box.max_mm - box.min_mm).dot(direction.cwiseAbs());
}

Eigen::Vector3d right_of(const Camera& camera) { return camera.sight.cross(camera.up).normalized(); }

}  // namespace

Camera look_from(PatientView view, const geometry::Box& box, double aspect, double margin) {
  Camera camera;
  camera.focus_mm = box.center_mm();
  camera.sight = sight_of(view);
  camera.up = up_for(camera.sight);
  const double half_height_mm =
      std::max(half_extent_mm(box, camera.up), half_extent_mm(box, right_of(camera)) / std::max(aspect, 1e-3));
  camera.visible_height_mm = std::max(2 * half_height_mm / (1 - 2 * margin), 1.0);
  return camera;
}

Camera look_at_slice(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& normal, double visible_height_mm) {
  // Transverse slices are seen from the feet, coronal from the front, sagittal from the patient's left.
  const Eigen::Vector3d from_where(-1, 1, 1);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Camera camera;
  camera.focus_mm = center_mm;
  camera.sight = normal.normalized() * (normal[axis] * from_where[axis] < 0 ? -1.0 : 1.0);
  camera.up = up_for(camera.sight);
  camera.visible_height_mm = visible_height_mm;
  camera.projection = Projection::parallel;
  return camera;
}

Camera turned(const Camera& camera, double right_deg, double up_deg) {
  constexpr double radians = std::numbers::pi / 180;
  // The object turns with the hand, so the eye turns the other way.
  const Eigen::AngleAxisd sideways(-right_deg * radians, camera.up);
  const Eigen::AngleAxisd upwards(up_deg * radians, right_of(camera));
  Camera outcome = camera;
  outcome.sight = (sideways * upwards * camera.sight).normalized();
  const Eigen::Vector3d up = sideways * upwards * camera.up;
  outcome.up = (up - up.dot(outcome.sight) * outcome.sight).normalized();
  return outcome;
}

Camera shifted(const Camera& camera, double right_mm, double up_mm) {
  Camera outcome = camera;
  outcome.focus_mm -= right_mm * right_of(camera) + up_mm * camera.up;
  return outcome;
}

}  // namespace glisson::scene
