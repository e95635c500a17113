#include "scene/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/colour.h"

namespace glisson::scene {

vision::Frame depth_picture(const vision::StereoCloud& cloud, int step_px) {
  const vision::Frame& seen = cloud.picture;
  vision::Frame both{2 * seen.width, seen.height, std::vector<std::uint8_t>(2 * seen.rgb.size(), 0)};
  for (int y = 0; y < seen.height; ++y) std::copy_n(seen.at(0, y), 3 * seen.width, both.at(0, y));
  if (cloud.points_mm.empty()) return both;
  std::vector<double> depths_mm;
  for (const Eigen::Vector3d& point : cloud.points_mm) depths_mm.push_back(point.z());
  std::sort(depths_mm.begin(), depths_mm.end());
  const double nearest_mm = depths_mm[depths_mm.size() / 50];  // stray points do not set the scale
  const double farthest_mm = depths_mm[depths_mm.size() - 1 - depths_mm.size() / 50];
  const double range_mm = std::max(1e-9, farthest_mm - nearest_mm);
  for (std::size_t i = 0; i < cloud.points_mm.size(); ++i) {
    const auto [red, green, blue] = colour_at(ColourMap::viridis, (farthest_mm - cloud.points_mm[i].z()) / range_mm);
    const auto byte = [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
    const auto& [left, top] = cloud.pixels[i];
    for (int y = top; y < std::min(top + step_px, seen.height); ++y) {
      for (int x = left; x < std::min(left + step_px, seen.width); ++x) {
        std::uint8_t* const pixel = both.at(seen.width + x, y);
        pixel[0] = byte(red);
        pixel[1] = byte(green);
        pixel[2] = byte(blue);
      }
    }
  }
  return both;
}

}  // namespace glisson::scene
