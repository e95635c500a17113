#pragma once
// What a laparoscope would see of a liver while it breathes and a tool presses it. SIMULATED: the motion is a formula,
// the colours are noise, the tool is a rod.
//
// All places are in the camera's space, mm: x to the right of the picture, y down, z away from the camera.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/surface.h"
#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::studies {

class ExampleScene {
 public:
  static constexpr int width = 640, height = 480;
  static constexpr double breath_frames = 20, press_frames = 27;  // periods

  // The liver in patient coordinates (LPS).
  explicit ExampleScene(const geometry::Surface& liver_lps);

  [[nodiscard]] const vision::Camera& camera() const { return camera_; }
  // From patient coordinates to where the liver lies at rest.
  [[nodiscard]] const Eigen::Isometry3d& pose() const { return pose_; }
  // The side of the liver that faces the camera, as it lies at rest.
  [[nodiscard]] const geometry::Surface& model() const { return model_; }
  // Where a point of the liver that lies there at rest is in a frame.
  [[nodiscard]] Eigen::Vector3d moved(const Eigen::Vector3d& rest_mm, double frame) const;

  // One frame: the picture, and what each pixel shows.
  struct View {
    vision::Frame picture;
    std::vector<double> depth_mm;          // [x + width * y]; infinite where the liver is not seen, as under the tool
    std::vector<Eigen::Vector3d> rest_mm;  // where the liver's point that is seen lies at rest

    [[nodiscard]] std::optional<double> depth_at(int x, int y) const;
  };
  // From an eye that far to the right of the camera; what is seen stays told in the camera's space, depths alike.
  [[nodiscard]] View view(double frame, double eye_mm = 0) const;

 private:
  [[nodiscard]] double pressing(double frame) const;  // 0..1
  void draw_liver(double frame, const Eigen::Vector3d& eye_mm, View& view) const;
  void draw_tool(double frame, const Eigen::Vector3d& eye_mm, View& view) const;

  vision::Camera camera_;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  geometry::Surface model_;
  Eigen::Vector3d headwards_{0, 0, 0};  // in the camera's space
  Eigen::Vector3d pressed_mm_{0, 0, 0};
  double left_mm_ = 0, across_mm_ = 1;
};

}  // namespace glisson::studies
