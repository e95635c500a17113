#include "mechanics/potentials/follower_pressure.h"

#include <Eigen/Geometry>

#include "mechanics/materials/deformation.h"
#include "mechanics/potentials/internal/face_geometry.h"

namespace glisson::mechanics {
using Eigen::Matrix3d;
using Eigen::VectorXd;

double FollowerPressure::energy_uJ(const VectorXd& u_mm) const {
  const auto cone_mm3 = [](const FaceNodes& nodes, const FacePoint& point) {
    const Matrix32d along = nodes * point.derivatives;
    return 0.5 * point.weight * (nodes * point.values).dot(along.col(0).cross(along.col(1))) / 3.0;
  };
  const std::vector<FacePoint> points = face_points(body_.options.order);
  double gained_mm3 = 0;
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm), rest = rest_nodes(body_, face);
    for (const FacePoint& point : points) gained_mm3 += cone_mm3(x, point) - cone_mm3(rest, point);
  }
  return pressure_kPa_ * gained_mm3;
}

void FollowerPressure::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  const std::vector<FacePoint> points = face_points(body_.options.order);
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm);
    FaceNodes on_nodes = FaceNodes::Zero(3, x.cols());
    for (const FacePoint& point : points) {
      const Matrix32d along = x * point.derivatives;
      on_nodes -= 0.5 * point.weight * pressure_kPa_ * along.col(0).cross(along.col(1)) * point.values.transpose();
    }
    for (Eigen::Index i = 0; i < x.cols(); ++i) force_mN.segment<3>(3 * face.nodes[i]) += on_nodes.col(i);
  }
}

void FollowerPressure::add_tangent(const VectorXd& u_mm, Tangent which, TangentSum& sum) const {
  if (which != Tangent::exact) return;
  const BlockSink sink = sum.within_cells();
  const std::vector<FacePoint> points = face_points(body_.options.order);
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm);
    const auto count = static_cast<int>(x.cols());
    // One face's part is not symmetric; the sum over the closed boundary is, and equals that of the symmetric parts.
    for (const FacePoint& point : points) {
      const Matrix32d along = x * point.derivatives;
      const Matrix3d first = cross_matrix(along.col(0)), second = cross_matrix(along.col(1));
      const auto by_node = [&](int a, int b) -> Matrix3d {
        return point.values[a] * (point.derivatives(b, 1) * first - point.derivatives(b, 0) * second);
      };
      for (int a = 0; a < count; ++a) {
        for (int b = 0; b < count; ++b) {
          sink.add(face.nodes[a], face.nodes[b],
                   0.25 * point.weight * pressure_kPa_ * (by_node(a, b) + by_node(b, a).transpose()));
        }
      }
    }
  }
}

double FollowerPressure::scale_uJ(const VectorXd& /*u_mm*/) const {
  return std::abs(pressure_kPa_) * geometry::volume_mm3(body_.mesh);
}

}  // namespace glisson::mechanics
