#pragma once
// Stereo videos whose truth is known: a picture of real tissue laid over a surface that breathes, seen by both eyes.

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <numbers>
#include <vector>

#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::test {

class StereoVideo {
 public:
  static constexpr int width = 480, height = 360;
  static constexpr double focal_px = 430, baseline_mm = 5.5;

  explicit StereoVideo(vision::Frame texture) : texture_(std::move(texture)) {}

  [[nodiscard]] static vision::StereoCalibration calibration() {
    vision::StereoCalibration camera;
    camera.left.matrix << focal_px, 0, width / 2.0, 0, focal_px, height / 2.0, 0, 0, 1;
    camera.right = camera.left;
    camera.left_to_right.translation() = Eigen::Vector3d(-baseline_mm, 0, 0);
    return camera;
  }

  // Where the tissue's place u, v (mm, as it lies at rest) is at frame t, in left-camera mm.
  [[nodiscard]] static Eigen::Vector3d place_mm(double u, double v, int t) {
    const auto [right_mm, down_mm] = drift(t);
    return {u + right_mm, v + down_mm, depth(u, v, t)};
  }
  // The tissue's place that was seen at that point in frame t.
  [[nodiscard]] static Eigen::Vector2d rest_mm(const Eigen::Vector3d& point_mm, int t) {
    const auto [right_mm, down_mm] = drift(t);
    return {point_mm.x() - right_mm, point_mm.y() - down_mm};
  }

  [[nodiscard]] vision::Frame left(int t) const { return picture(t, 0); }
  [[nodiscard]] vision::Frame right(int t) const { return picture(t, baseline_mm); }

 private:
  static std::pair<double, double> drift(int t) {
    const double phase = 2 * std::numbers::pi * t / 20;
    return {3 * std::sin(phase), 2 * std::sin(phase + 1)};
  }
  static double depth(double u, double v, int t) {
    const double breath = std::sin(2 * std::numbers::pi * t / 20);
    return 72 - 9 * std::exp(-(u * u + v * v) / 900) - 4 * breath * (0.5 + u / 90);
  }

  [[nodiscard]] vision::Frame picture(int t, double eye_mm) const {
    vision::Frame frame{width, height, std::vector<std::uint8_t>(3 * width * height)};
    const auto [right_mm, down_mm] = drift(t);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double slope_x = (x - width / 2.0) / focal_px, slope_y = (y - height / 2.0) / focal_px;
        double z = 68, u = 0, v = 0;
        for (int i = 0; i < 6; ++i) {  // the ray meets a surface that is nearly square to it
          u = eye_mm + slope_x * z - right_mm;
          v = slope_y * z - down_mm;
          z = depth(u, v, t);
        }
        shade(u, v, frame.at(x, y));
      }
    }
    return frame;
  }

  // The texture at 0.3 mm a pixel, between its pixels linearly; beyond its edges mirrored.
  void shade(double u, double v, std::uint8_t* pixel) const {
    constexpr double pixel_mm = 0.3;
    const auto folded = [](double at, int size) {
      const double period = 2.0 * (size - 1);
      const double within = std::fmod(std::fmod(at, period) + period, period);
      return std::clamp(within <= size - 1 ? within : period - within, 0.0, size - 1.001);
    };
    const double x = folded(u / pixel_mm + texture_.width / 2.0, texture_.width);
    const double y = folded(v / pixel_mm + texture_.height / 2.0, texture_.height);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const double right = x - x0, down = y - y0;
    for (int channel = 0; channel < 3; ++channel) {
      const double value =
          (1 - down) * ((1 - right) * texture_.at(x0, y0)[channel] + right * texture_.at(x0 + 1, y0)[channel]) +
          down * ((1 - right) * texture_.at(x0, y0 + 1)[channel] + right * texture_.at(x0 + 1, y0 + 1)[channel]);
      pixel[channel] = static_cast<std::uint8_t>(std::lround(value));
    }
  }

  vision::Frame texture_;
};

}  // namespace glisson::test
