#pragma once
// The walls of cuts, which may touch and slide along each other and not pass through: where a point of one meets a
// triangle of another, found anew as they move. Inside of this room.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/surface.h"

namespace glisson::mechanics {

// A point of a wall and the place of the wall across from it, both nodes of the body (3 values each).
struct CutContact {
  std::size_t owner, triangle;  // in the order of CutSelfContact
  int point;
  std::array<int, 3> corners;
  Eigen::Vector3d weights;
  Eigen::Vector3d normal;   // out of the triangle
  Eigen::Vector3d rest_mm;  // from the place to the point
  double depth_mm = 0;      // from the place to the point when it was found, if that was behind it
  double force_mN = 0;      // that it is known to bear

  // Below zero where the point has passed through the triangle.
  [[nodiscard]] double gap_mm(const Eigen::VectorXd& u_mm) const {
    Eigen::Vector3d apart_mm = rest_mm + u_mm.segment<3>(3 * point);
    for (int i = 0; i < 3; ++i) apart_mm -= weights[i] * u_mm.segment<3>(3 * corners[i]);
    return normal.dot(apart_mm);
  }
  // The four nodes with the share of the normal that each is pushed along.
  [[nodiscard]] std::array<std::pair<int, double>, 4> shares() const {
    return {{{point, 1.0}, {corners[0], -weights[0]}, {corners[1], -weights[1]}, {corners[2], -weights[2]}}};
  }
};

class CutSelfContact {
 public:
  CutSelfContact() = default;
  // `surface` is the body's, at rest; `wall_points` are those of its points that lie on a wall.
  CutSelfContact(const geometry::Surface& surface, const std::vector<int>& node_of_point,
                 const std::vector<int>& wall_points);

  // Where the points are with the body moved by u: nearer than 1 mm to a triangle that faces them, or up to 5 mm behind
  // it; a force stays with its point. Anew: no others. Again: where a point is found nowhere, its last place stays.
  // More: all places stay, on the triangles that are not met now. For a point over an edge or a rim that met one
  // triangle and another, or one and none, by turns would never come to rest.
  enum class Search { anew, again, more };
  // Gives back how far a point is from the place that it met, behind it, at most.
  double find(const Eigen::VectorXd& u_mm, Search search);

  [[nodiscard]] std::vector<CutContact>& cut_contacts() { return cut_contacts_; }
  [[nodiscard]] const std::vector<CutContact>& cut_contacts() const { return cut_contacts_; }

 private:
  struct Triangle {
    std::array<int, 3> nodes;
    std::array<Eigen::Vector3d, 3> rest_mm;
  };
  [[nodiscard]] std::vector<CutContact> cut_contacts_now(const Eigen::VectorXd& u_mm) const;

  std::vector<Triangle> triangles_;
  std::vector<std::vector<int>> around_;    // triangles at each point
  std::vector<Eigen::Vector3d> points_mm_;  // at rest
  std::vector<int> nodes_;                  // of the points
  std::vector<CutContact> cut_contacts_;    // by owners
};

}  // namespace glisson::mechanics
