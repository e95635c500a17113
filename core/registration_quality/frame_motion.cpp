#include "registration_quality/internal/frame_motion.h"

#include <algorithm>
#include <limits>

#include "geometry/surface.h"

namespace glisson::registration_quality {

using Eigen::Vector3d;

FrameMotion::FrameMotion(const RegisteredFrame& frame, std::size_t maximum_points) {
  const std::size_t step = std::max<std::size_t>(1, frame.cloud_mm.size() / maximum_points);
  for (std::size_t i = 0; i < frame.cloud_mm.size(); i += step) {
    if (!frame.cloud_mm[i].allFinite() || !frame.registered_mm[i].allFinite()) continue;
    cloud_mm_.push_back(frame.cloud_mm[i]);
    registered_mm_.push_back(frame.registered_mm[i]);
  }
  if (cloud_mm_.empty()) return;
  reach_mm_ = std::max(geometry::bounding_box(cloud_mm_).diagonal_mm(), std::numeric_limits<double>::min());
  from_cloud_.emplace(cloud_mm_);
  from_registered_.emplace(registered_mm_);
}

Vector3d FrameMotion::mean_displacement(const geometry::NearestPoint& tree, const Vector3d& place_mm,
                                        double sign) const {
  constexpr int neighbours = 4;
  constexpr double smallest_mm2 = 1e-6;  // nearer than this is there
  Vector3d sum = Vector3d::Zero();
  double total = 0;
  for (const auto& [point, squared_mm2] : tree.nearest(place_mm, neighbours)) {
    const double weight = 1 / std::max(squared_mm2, smallest_mm2);
    const auto i = static_cast<std::size_t>(point);
    sum += weight * sign * (registered_mm_[i] - cloud_mm_[i]);
    total += weight;
  }
  return sum / total;
}

}  // namespace glisson::registration_quality
