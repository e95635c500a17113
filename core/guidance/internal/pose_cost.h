#pragma once
// How badly a pose of the organ explains a frame, and the steps that make it explain it better.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/nearest.h"
#include "geometry/surface.h"
#include "guidance/frame.h"

namespace glisson::guidance {

constexpr double far_mm = 20;  // beyond which a point counts as not explained

class PoseCost {
 public:
  // Of the cloud and of each curve, at most so many points are asked. `surface` is the organ's at rest, its triangles
  // counter-clockwise from outside.
  PoseCost(const geometry::Surface& surface, const SeenFrame& frame, std::size_t maximum_points);

  // Mean distance of the seen curves from the curves at rest, mm; none above far_mm, 0 where there are none.
  [[nodiscard]] double of_curves(const Eigen::Isometry3d& pose) const;
  // Of the cloud from the surface. A point that would lie on a side turned away from the camera is not explained.
  [[nodiscard]] double of_cloud(const Eigen::Isometry3d& pose) const;
  [[nodiscard]] double of_curves_and_cloud(const Eigen::Isometry3d& pose) const {
    return of_curves(pose) + of_cloud(pose);
  }

  // One step of iterated closest points, by pairs within `reach_mm` of each other. Nothing where they are too few.
  [[nodiscard]] std::optional<Eigen::Isometry3d> step_to_points(const Eigen::Isometry3d& pose, double reach_mm) const;
  // One step of the cloud to the planes that it lies next to (Chen and Medioni 1992, Image Vis. Comput. 10:145), and of
  // curves to the places that they lie next to, with Cauchy's weights. It slides along the surface where points to
  // points creep.
  [[nodiscard]] std::optional<Eigen::Isometry3d> step_to_planes(const Eigen::Isometry3d& pose, double reach_mm) const;

  [[nodiscard]] const std::vector<Eigen::Vector3d>& cloud_mm() const { return cloud_mm_; }
  [[nodiscard]] const Eigen::Vector3d& cloud_middle_mm() const { return middle_mm_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& normals() const { return normals_; }  // one a triangle, outwards

 private:
  struct Curve {
    geometry::NearestPoint at_rest;
    std::vector<Eigen::Vector3d> seen_mm;
  };
  [[nodiscard]] bool is_turned_away(const Eigen::Isometry3d& pose, int triangle, const Eigen::Vector3d& seen_mm) const;

  geometry::SurfaceDistance surface_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Curve> curves_;
  std::vector<Eigen::Vector3d> cloud_mm_;
  Eigen::Vector3d middle_mm_{0, 0, 0};  // of the cloud
};

}  // namespace glisson::guidance
