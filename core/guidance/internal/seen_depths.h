#pragma once
// A cloud as a coarse picture of depths, and what of it an organ in a pose would contradict: where it would stand
// before what was seen, and where it would be seen but nothing was. A cloud alone says only where the organ is.

#include <Eigen/Geometry>
#include <vector>

#include "geometry/surface.h"

namespace glisson::guidance {

class SeenDepths {
 public:
  // In the camera's frame, which looks along z from the origin.
  explicit SeenDepths(const std::vector<Eigen::Vector3d>& cloud_mm);

  // Whether the cloud is a picture: dense, and before the camera. Lines that a stylus drew leave most of it empty.
  [[nodiscard]] bool is_picture() const { return is_picture_; }

  // Shares of the cells that were seen: `before`, cells where the organ would stand in front of what was seen;
  // `unseen`, further cells that it would fill. Only of a picture. Triangles nearer than 5 mm are passed over.
  struct Contradiction {
    double before = 0;
    double unseen = 0;
  };
  [[nodiscard]] Contradiction contradiction(const geometry::Surface& organ, const Eigen::Isometry3d& pose) const;

 private:
  [[nodiscard]] std::vector<double> depths_of(const geometry::Surface& organ, const Eigen::Isometry3d& pose) const;

  bool is_picture_ = false;
  Eigen::Vector2d min_{0, 0}, cell_{0, 0};  // x / z and y / z
  std::vector<double> depth_mm_;            // the nearest seen in a cell, 0 where nothing was
  std::vector<char> is_near_seen_;          // a cell or one next to it was seen
  double seen_cells_ = 0;
};

}  // namespace glisson::guidance
