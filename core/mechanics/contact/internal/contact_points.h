#pragma once
// Where tools at large deformation press on a body: at quadrature points of its boundary's faces, each standing for its
// share of the area. What presses there is borne by the face's nodes by their shape functions, so that a uniform
// pressure is borne as it is in truth: by a quadratic face's middles of edges, and not by its corners. A face that a
// tool could enter deeper than it may between its points is divided for it in four, sixteen or sixty-four.
//
// Source: Fischer and Wriggers 2005, Computational Mechanics 36:226 (contact integrated over quadrature points);
// Strang and Fix, An Analysis of the Finite Element Method, 4.3 (the rule of degree 2).

#include <array>
#include <Eigen/Core>
#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// Of a face of Body::boundary, one of the points that it has at each fineness.
struct ContactPoint {
  int face = 0, point = 0;

  friend bool operator==(const ContactPoint&, const ContactPoint&) = default;
};

struct ContactPointWeights {
  std::array<int, 6> nodes;  // those that a linear face lacks are its first, with a weight of 0
  Eigen::Matrix<double, 6, 1> values;
  Eigen::Vector3d rest_mm;
  double area_mm2;
};
[[nodiscard]] ContactPointWeights weights_at(const Body& body, const ContactPoint& at);

struct NearPoint {
  std::size_t tool, rod;
  ContactPoint at;
  double gap_mm;
};

// Those points whose gap to a rod is at most the margin. `u_mm` has 3 values a node; `advance_mm` one a tool, how far
// it slid from its pose. Graspers touch nothing. Between points a tool lies
// no more than `deepest_between_mm` deeper.
[[nodiscard]] std::vector<NearPoint> points_near(const Body& body, const std::vector<ContactTool>& tools,
                                                 const Eigen::VectorXd& advance_mm, const Eigen::VectorXd& u_mm,
                                                 double margin_mm, double deepest_between_mm);

}  // namespace glisson::mechanics
