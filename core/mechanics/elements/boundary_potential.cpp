#include "mechanics/elements/boundary_potential.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/capsule.h"
#include "mechanics/materials/deformation.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A face's functions at one of its points: values, and derivatives by two of the barycentric coordinates (the third
// makes up for them).
struct FacePoint {
  double weight;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> values;
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 6, 2> derivatives;
};
std::vector<FacePoint> face_points(ElementOrder order);

// Node positions of a face, one a column.
using FaceNodes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6>;
FaceNodes rest_of(const Body& body, const BoundaryFace& face);
FaceNodes moved(const Body& body, const BoundaryFace& face, const VectorXd& u_mm);

// The capsule over one face: what its points are mapped by, and the gradients of the functions in the rest plane.
struct SkinPoint {
  double area_mm2;
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 6, 2> gradients;
};
std::vector<SkinPoint> skin_points(const Body& body, const BoundaryFace& face, const std::vector<FacePoint>& points);
bool has_capsule(const Body& body, const BoundaryFace& face);

struct Pull {
  double beyond_mm;  // how far the spring is longer than what it gives for nothing; below 0 where it is slack
  double length_mm;
  Vector3d towards_anchor;
};
Pull pull_of(const Body& body, const LigamentSpring& spring, const VectorXd& u_mm);

}  // namespace

double boundary_energy_uJ(const Body& body, double pressure_kPa, const VectorXd& u_mm) {
  double energy_uJ = -0.5 * u_mm.dot(foundation_force_mN(body, u_mm));
  for (const LigamentSpring& spring : body.resolved.ligaments) {
    const double beyond_mm = std::max(0.0, pull_of(body, spring, u_mm).beyond_mm);
    energy_uJ += 0.5 * spring.stiffness_mN_per_mm * beyond_mm * beyond_mm;
  }
  if (!body.options.capsule && pressure_kPa == 0) return energy_uJ;
  const std::vector<FacePoint> points = face_points(body.options.order);
  for (const BoundaryFace& face : body.boundary) {
    const FaceNodes x = moved(body, face, u_mm);
    if (has_capsule(body, face)) {
      for (const SkinPoint& skin : skin_points(body, face, points)) {
        energy_uJ += skin.area_mm2 * energy_per_area(*body.options.capsule, x * skin.gradients);
      }
    }
    if (pressure_kPa == 0) continue;
    const FaceNodes rest = rest_of(body, face);
    const auto cone_mm3 = [&](const FaceNodes& nodes, const FacePoint& point) {
      const Matrix32d along = nodes * point.derivatives;
      return 0.5 * point.weight * (nodes * point.values).dot(along.col(0).cross(along.col(1))) / 3.0;
    };
    for (const FacePoint& point : points) energy_uJ += pressure_kPa * (cone_mm3(x, point) - cone_mm3(rest, point));
  }
  return energy_uJ;
}

VectorXd boundary_force_mN(const Body& body, double pressure_kPa, const VectorXd& u_mm) {
  VectorXd force_mN = foundation_force_mN(body, u_mm) + ligament_force_mN(body, u_mm);
  if (!body.options.capsule && pressure_kPa == 0) return force_mN;
  const std::vector<FacePoint> points = face_points(body.options.order);
  for (const BoundaryFace& face : body.boundary) {
    const FaceNodes x = moved(body, face, u_mm);
    FaceNodes on_nodes = FaceNodes::Zero(3, x.cols());
    if (has_capsule(body, face)) {
      for (const SkinPoint& skin : skin_points(body, face, points)) {
        on_nodes -=
            skin.area_mm2 * membrane_stress(*body.options.capsule, x * skin.gradients) * skin.gradients.transpose();
      }
    }
    if (pressure_kPa != 0) {
      for (const FacePoint& point : points) {
        const Matrix32d along = x * point.derivatives;
        on_nodes -= 0.5 * point.weight * pressure_kPa * along.col(0).cross(along.col(1)) * point.values.transpose();
      }
    }
    for (Eigen::Index i = 0; i < x.cols(); ++i) force_mN.segment<3>(3 * face.nodes[i]) += on_nodes.col(i);
  }
  return force_mN;
}

void add_boundary_tangent(const Body& body, double pressure_kPa, const VectorXd& u_mm, Tangent which,
                          const BlockSink& sink) {
  for (const FoundationFace& spring : body.resolved.foundations) {
    add_foundation(body.boundary[spring.face], spring, body.options.order, sink);
  }
  for (const LigamentSpring& spring : body.resolved.ligaments) {
    const auto [beyond_mm, length_mm, along] = pull_of(body, spring, u_mm);
    // At the very edge of slackness the tangent is that of the pull: a body that is about to hang must not fly.
    if (beyond_mm < 0 || length_mm == 0) continue;
    const Matrix3d axial = along * along.transpose();
    sink.add(spring.node, spring.node,
             spring.stiffness_mN_per_mm * (axial + beyond_mm / length_mm * (Matrix3d::Identity() - axial)));
  }
  const bool gas = pressure_kPa != 0 && which == Tangent::exact;
  if (!body.options.capsule && !gas) return;
  const std::vector<FacePoint> points = face_points(body.options.order);
  for (const BoundaryFace& face : body.boundary) {
    const FaceNodes x = moved(body, face, u_mm);
    const auto count = static_cast<int>(x.cols());
    if (has_capsule(body, face)) {
      for (const SkinPoint& skin : skin_points(body, face, points)) {
        Matrix6d tangent = membrane_tangent(*body.options.capsule, x * skin.gradients);
        if (which != Tangent::exact) tangent = positive_part(tangent);
        for (int a = 0; a < count; ++a) {
          for (int b = 0; b < count; ++b) {
            Matrix3d block = Matrix3d::Zero();
            for (int i = 0; i < 2; ++i) {
              for (int j = 0; j < 2; ++j) {
                block += skin.gradients(a, i) * skin.gradients(b, j) * tangent.block<3, 3>(3 * i, 3 * j);
              }
            }
            sink.add(face.nodes[a], face.nodes[b], skin.area_mm2 * block);
          }
        }
      }
    }
    if (!gas) continue;
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
                   0.25 * point.weight * pressure_kPa * (by_node(a, b) + by_node(b, a).transpose()));
        }
      }
    }
  }
}

VectorXd ligament_force_mN(const Body& body, const VectorXd& u_mm) {
  VectorXd force_mN = VectorXd::Zero(u_mm.size());
  for (const LigamentSpring& spring : body.resolved.ligaments) {
    const Pull pull = pull_of(body, spring, u_mm);
    if (pull.beyond_mm <= 0) continue;
    force_mN.segment<3>(3 * spring.node) += spring.stiffness_mN_per_mm * pull.beyond_mm * pull.towards_anchor;
  }
  return force_mN;
}

namespace {

std::vector<FacePoint> face_points(ElementOrder order) {
  std::vector<FacePoint> points;
  for (const TrianglePoint& at : triangle_points_degree_4()) {
    const Vector3d& l = at.barycentric;
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

FaceNodes rest_of(const Body& body, const BoundaryFace& face) {
  const int count = body.options.order == ElementOrder::linear ? 3 : 6;
  FaceNodes nodes(3, count);
  for (int i = 0; i < count; ++i) nodes.col(i) = body.layout.positions_mm[face.nodes[i]];
  return nodes;
}

FaceNodes moved(const Body& body, const BoundaryFace& face, const VectorXd& u_mm) {
  FaceNodes nodes = rest_of(body, face);
  for (Eigen::Index i = 0; i < nodes.cols(); ++i) nodes.col(i) += u_mm.segment<3>(3 * face.nodes[i]);
  return nodes;
}

std::vector<SkinPoint> skin_points(const Body& body, const BoundaryFace& face, const std::vector<FacePoint>& points) {
  const FaceNodes rest = rest_of(body, face);
  const Vector3d first = (rest.col(0) - rest.col(2)).normalized(), second = face.normal.cross(first);
  Matrix32d plane;
  plane << first, second;
  // d rest / d barycentric, in the plane; the same all over a face with straight edges.
  Eigen::Matrix2d jacobian;
  jacobian << plane.transpose() * (rest.col(0) - rest.col(2)), plane.transpose() * (rest.col(1) - rest.col(2));
  const Eigen::Matrix2d inverse = jacobian.inverse();
  std::vector<SkinPoint> skin;
  for (const FacePoint& point : points) {
    skin.push_back({point.weight * face.area_mm2, point.derivatives * inverse});
    if (body.options.order == ElementOrder::linear) {  // stretched evenly: one point stands for all
      skin.back().area_mm2 = face.area_mm2;
      break;
    }
  }
  return skin;
}

bool has_capsule(const Body& body, const BoundaryFace&) { return body.options.capsule.has_value(); }

Pull pull_of(const Body& body, const LigamentSpring& spring, const VectorXd& u_mm) {
  const Vector3d arm_mm = spring.anchor_mm - body.layout.positions_mm[spring.node] - u_mm.segment<3>(3 * spring.node);
  const double length_mm = arm_mm.norm();
  if (length_mm == 0) return {0, 0, Vector3d::Zero()};
  // Rounding at rest must not decide between taut and slack.
  const double beyond_mm = length_mm - spring.free_length_mm;
  return {beyond_mm > -1e-12 * length_mm ? std::max(0.0, beyond_mm) : -1.0, length_mm, arm_mm / length_mm};
}

}  // namespace
}  // namespace glisson::mechanics
