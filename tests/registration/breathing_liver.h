#pragma once
// The front of a liver as a laparoscope's frames see it: breathing, pressed by a tool that comes and goes, with noise.

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/manifold.h"
#include "geometry/surface.h"

namespace glisson::registration::test {

// A frame's surface; point i is the liver's vertex[i].
struct SeenFrame {
  geometry::Surface surface;
  std::vector<int> vertex;
};

// 20 frames a breath, of some 10 mm; the tool presses 8 mm deep.
inline SeenFrame breathing_liver(const geometry::Surface& liver, int frame, double noise_mm) {
  using Eigen::Vector3d;
  std::mt19937 random(static_cast<unsigned>(frame) + 1);
  std::normal_distribution<double> noise(0, noise_mm);
  const auto box = geometry::bounding_box(liver.points_mm);
  const Vector3d size_mm = box.max_mm - box.min_mm;
  const Vector3d tool_mm = box.center_mm() + 0.25 * size_mm.cwiseProduct(Vector3d(1, -2, 0));
  const double breath = std::sin(2 * std::numbers::pi * frame / 20.0);
  const double press_mm = 8 * std::max(0.0, std::sin(2 * std::numbers::pi * frame / 27.0 + 1));
  geometry::Surface seen;
  geometry::Field vertex{"vertex", 1, {}};
  for (std::size_t i = 0; i < liver.points_mm.size(); ++i) {
    const Vector3d& rest_mm = liver.points_mm[i];
    const double across = (rest_mm.x() - box.min_mm.x()) / size_mm.x();
    const double pressed_mm = press_mm * std::exp(-(rest_mm - tool_mm).squaredNorm() / 900.0);
    seen.points_mm.push_back(rest_mm + breath * Vector3d(1, 2, 8 + 6 * across) + pressed_mm * Vector3d::UnitY() +
                             Vector3d(noise(random), noise(random), noise(random)));
    vertex.values.push_back(static_cast<double>(i));
  }
  const auto normals = geometry::point_normals(liver);
  for (const auto& triangle : liver.triangles) {
    bool in_front = true;  // of a camera that looks along y
    for (const int corner : triangle) in_front = in_front && normals[static_cast<std::size_t>(corner)].y() < -0.3;
    if (in_front) seen.triangles.push_back(triangle);
  }
  geometry::set_field(seen.point_fields, vertex);
  SeenFrame result{geometry::largest_manifold_piece(seen), {}};
  for (const double id : geometry::find_field(result.surface.point_fields, "vertex")->values) {
    result.vertex.push_back(static_cast<int>(id));
  }
  return result;
}

// How far each frame's points are led from where they belong on the liver (mm, through space), on average.
inline double mean_error_mm(const geometry::Surface& liver, const SeenFrame& frame,
                            const std::vector<int>& frame_points, const std::vector<int>& liver_points) {
  double sum_mm = 0;
  for (std::size_t i = 0; i < frame_points.size(); ++i) {
    const int belongs = frame.vertex[static_cast<std::size_t>(frame_points[i])];
    sum_mm += (liver.points_mm[static_cast<std::size_t>(belongs)] -
               liver.points_mm[static_cast<std::size_t>(liver_points[i])])
                  .norm();
  }
  return sum_mm / static_cast<double>(frame_points.size());
}

}  // namespace glisson::registration::test
