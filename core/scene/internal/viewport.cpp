#include "scene/internal/viewport.h"

#include <cmath>
#include <numbers>

namespace glisson::scene {

double Viewport::eye_distance_mm() const {
  const double half_angle = 0.5 * perspective_angle_deg * std::numbers::pi / 180;
  return 0.5 * camera.visible_height_mm / std::tan(half_angle);
}

Eigen::Vector2d Viewport::pixel_of(const Eigen::Vector3d& position_mm) const {
  const Eigen::Vector3d from_focus = position_mm - camera.focus_mm;
  double scale = pixels_per_mm();
  if (camera.projection == Projection::perspective) {
    const double depth_mm = eye_distance_mm() + from_focus.dot(camera.sight);
    scale *= eye_distance_mm() / std::max(depth_mm, 1e-6);
  }
  return {0.5 * width + scale * from_focus.dot(right()), 0.5 * height + scale * from_focus.dot(camera.up)};
}

Eigen::Vector3d Viewport::in_focal_plane(double x, double y) const {
  return camera.focus_mm + (x - 0.5 * width) / pixels_per_mm() * right() +
         (y - 0.5 * height) / pixels_per_mm() * camera.up;
}

Ray Viewport::ray_through(double x, double y) const {
  const Eigen::Vector3d through_mm = in_focal_plane(x, y);
  if (camera.projection == Projection::parallel) {
    return {through_mm - eye_distance_mm() * camera.sight, camera.sight};
  }
  return {eye_mm(), (through_mm - eye_mm()).normalized()};
}

}  // namespace glisson::scene
