#pragma once
// Self-contact of the faces of cuts, which may touch and slide and not pass through each other. Pairs of a point of one
// face and a triangle of another are found anew as they move.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/surface.h"

namespace glisson::mechanics {

// A point of a face and the triangle across from it, both nodes of the body (3 values each).
struct CutContact {
  std::size_t owner, triangle;  // in the order of CutSelfContact
  int point;
  std::array<int, 3> corners;
  Eigen::Vector3d weights;
  Eigen::Vector3d normal;    // out of the triangle
  Eigen::Vector3d rest_mm;   // from the place to the point
  double depth_mm = 0;       // from the place to the point when it was found, if that was behind it
  double multiplier_mN = 0;  // the normal force found so far

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

  // Finds the contacts with the body moved by u. These are points nearer than 1 mm to a triangle that faces them, or up
  // to 5 mm behind it. A multiplier stays with its point.
  // - anew: contacts found now alone.
  // - again: a point that is found nowhere keeps its last contact.
  // - more: earlier contacts stay beside those found now. A point over an edge or a rim would else change triangles
  //   from round to round and never come to rest.
  enum class Search { anew, again, more };
  // Gives back the deepest penetration.
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
