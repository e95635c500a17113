#include "mechanics/potentials/internal/face_geometry.h"

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {

std::vector<FacePoint> face_points(ElementOrder order) {
  std::vector<FacePoint> points;
  for (const TrianglePoint& at : triangle_points_degree_4()) {
    const Eigen::Vector3d& l = at.barycentric;
    FacePoint point;
    point.weight = at.weight;
    if (order == ElementOrder::linear) {
      point.values = l;
      point.derivatives.resize(3, 2);
      point.derivatives << 1, 0, 0, 1, -1, -1;
    } else {
      point.values = quadratic_triangle_values(l);
      Eigen::Matrix<double, 6, 3> by_l = Eigen::Matrix<double, 6, 3>::Zero();
      for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        by_l(i, i) = 4.0 * l[i] - 1.0;
        by_l(3 + i, i) = 4.0 * l[next];
        by_l(3 + i, next) = 4.0 * l[i];
      }
      point.derivatives.resize(6, 2);
      point.derivatives.col(0) = by_l.col(0) - by_l.col(2);
      point.derivatives.col(1) = by_l.col(1) - by_l.col(2);
    }
    points.push_back(std::move(point));
  }
  return points;
}

FaceNodes rest_nodes(const Body& body, const BoundaryFace& face) {
  const int count = body.options.order == ElementOrder::linear ? 3 : 6;
  FaceNodes nodes(3, count);
  for (int i = 0; i < count; ++i) nodes.col(i) = body.layout.positions_mm[face.nodes[i]];
  return nodes;
}

FaceNodes displaced_nodes(const Body& body, const BoundaryFace& face, const Eigen::VectorXd& u_mm) {
  FaceNodes nodes = rest_nodes(body, face);
  for (Eigen::Index i = 0; i < nodes.cols(); ++i) nodes.col(i) += u_mm.segment<3>(3 * face.nodes[i]);
  return nodes;
}

}  // namespace glisson::mechanics
