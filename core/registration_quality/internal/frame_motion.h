#pragma once
// One frame of a registered sequence, asked which way its points went.

#include <cmath>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/nearest.h"
#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

// Its finite pairs of points, at most so many, evenly chosen.
class FrameMotion {
 public:
  FrameMotion(const RegisteredFrame& frame, std::size_t maximum_points);

  [[nodiscard]] bool empty() const { return cloud_mm_.empty(); }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& registered_mm() const { return registered_mm_; }
  // Where the registration puts a place of the frame, by the pairs around it.
  [[nodiscard]] Eigen::Vector3d to_model(const Eigen::Vector3d& place_mm) const {
    return place_mm + mean_displacement(*from_cloud_, place_mm, 1);
  }
  // How a place in the model's space is displaced to lie in the frame.
  [[nodiscard]] Eigen::Vector3d displacement_to_frame(const Eigen::Vector3d& place_mm) const {
    return mean_displacement(*from_registered_, place_mm, -1);
  }
  // How far a place lies from the frame's points, as a fraction of how far these reach (diagonal of their box).
  [[nodiscard]] double distance_from_cloud(const Eigen::Vector3d& place_mm) const {
    return std::sqrt(from_cloud_->nearest(place_mm).squared_distance_mm2) / reach_mm_;
  }
  [[nodiscard]] double distance_to_registered_mm(const Eigen::Vector3d& place_mm) const {
    return std::sqrt(from_registered_->nearest(place_mm).squared_distance_mm2);
  }

 private:
  [[nodiscard]] Eigen::Vector3d mean_displacement(const geometry::NearestPoint& tree, const Eigen::Vector3d& place_mm,
                                                  double sign) const;

  std::vector<Eigen::Vector3d> cloud_mm_, registered_mm_;
  double reach_mm_ = 0;
  std::optional<geometry::NearestPoint> from_cloud_, from_registered_;
};

}  // namespace glisson::registration_quality
