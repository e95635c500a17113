#pragma once
// A camera and the size of the picture that it fills: where positions fall in it, and what lies under a pixel.
// Pixels count from the lower left corner.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "scene/camera.h"

namespace glisson::scene {

// Between the picture's lower and upper edge; narrow, so that shapes near the edge are not stretched.
inline constexpr double perspective_angle_deg = 24;

struct Ray {
  Eigen::Vector3d origin_mm{0, 0, 0};
  Eigen::Vector3d direction{0, 0, 1};  // unit
};

struct Viewport {
  Camera camera;
  int width = 1;
  int height = 1;

  [[nodiscard]] Eigen::Vector3d right() const { return camera.sight.cross(camera.up).normalized(); }
  [[nodiscard]] double pixels_per_mm() const { return height / camera.visible_height_mm; }  // in the focal plane
  [[nodiscard]] double eye_distance_mm() const;
  [[nodiscard]] Eigen::Vector3d eye_mm() const { return camera.focus_mm - eye_distance_mm() * camera.sight; }
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] Ray ray_through(double x, double y) const;
  [[nodiscard]] Eigen::Vector3d in_focal_plane(double x, double y) const;
};

}  // namespace glisson::scene
