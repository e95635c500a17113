#pragma once
// Faces of a body's boundary, displaced, and the points that integrals over them are sampled at.

#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// A face's functions at one of its points: values, and derivatives by two of the barycentric coordinates (the third
// makes up for them).
struct FacePoint {
  double weight;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> values;
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 6, 2> derivatives;
};
[[nodiscard]] std::vector<FacePoint> face_points(ElementOrder order);

// Node positions of a face (mm), one a column.
using FaceNodes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6>;
[[nodiscard]] FaceNodes rest_nodes(const Body& body, const BoundaryFace& face);
[[nodiscard]] FaceNodes displaced_nodes(const Body& body, const BoundaryFace& face, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
