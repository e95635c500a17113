#pragma once
// The surface of a body of quadratic tetrahedra, and the places on it that are nearest to points.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"

namespace glisson::closedloop {

// The organ's surface by its quadratic faces, each seen as four triangles between its nodes.
class QuadraticSurface {
 public:
  explicit QuadraticSurface(const mechanics::Body& body);

  [[nodiscard]] const std::vector<Eigen::Vector3d>& rest_mm() const { return rest_mm_; }

  // A place on the surface: values at its six nodes (by their number in rest_mm) with these weights.
  struct Place {
    std::array<Eigen::Index, 6> nodes{};
    Eigen::Matrix<double, 6, 1> weights;
    Eigen::Vector3d normal{0, 0, 1};  // of the surface as it lies there
    double distance_mm = 0;           // of the point asked for: positive outside
  };
  // `positions_mm` of the nodes, as many as rest_mm; the points' places, each nearest.
  [[nodiscard]] std::vector<Place> nearest(const std::vector<Eigen::Vector3d>& positions_mm,
                                           const std::vector<Eigen::Vector3d>& points_mm) const;

 private:
  std::vector<std::array<int, 6>> faces_;      // corners, then the middles of 0-1, 1-2, 2-0
  std::vector<std::array<int, 3>> triangles_;  // four a face, in the order of `parts`
  std::vector<Eigen::Vector3d> rest_mm_;
};

}  // namespace glisson::closedloop
