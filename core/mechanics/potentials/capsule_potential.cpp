#include "mechanics/potentials/capsule_potential.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mechanics/materials/capsule.h"
#include "mechanics/materials/deformation.h"
#include "mechanics/potentials/internal/face_geometry.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A point of the capsule over one face: the area it stands for, and the gradients of the functions in the rest plane.
struct SkinPoint {
  double area_mm2;
  Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 6, 2> gradients;
};
std::vector<SkinPoint> skin_points(const Body& body, const BoundaryFace& face, const std::vector<FacePoint>& points);

}  // namespace

double CapsulePotential::energy_uJ(const VectorXd& u_mm) const {
  const std::vector<FacePoint> points = face_points(body_.options.order);
  double sum_uJ = 0;
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm);
    for (const SkinPoint& skin : skin_points(body_, face, points)) {
      sum_uJ += skin.area_mm2 * energy_per_area(*body_.options.capsule, x * skin.gradients);
    }
  }
  return sum_uJ;
}

void CapsulePotential::add_force(const VectorXd& u_mm, VectorXd& force_mN) const {
  const std::vector<FacePoint> points = face_points(body_.options.order);
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm);
    FaceNodes on_nodes = FaceNodes::Zero(3, x.cols());
    for (const SkinPoint& skin : skin_points(body_, face, points)) {
      on_nodes -=
          skin.area_mm2 * membrane_stress(*body_.options.capsule, x * skin.gradients) * skin.gradients.transpose();
    }
    for (Eigen::Index i = 0; i < x.cols(); ++i) force_mN.segment<3>(3 * face.nodes[i]) += on_nodes.col(i);
  }
}

void CapsulePotential::add_tangent(const VectorXd& u_mm, Tangent which, TangentSum& sum) const {
  const BlockSink sink = sum.within_cells();
  const std::vector<FacePoint> points = face_points(body_.options.order);
  for (const BoundaryFace& face : body_.boundary) {
    const FaceNodes x = displaced_nodes(body_, face, u_mm);
    const auto count = static_cast<int>(x.cols());
    for (const SkinPoint& skin : skin_points(body_, face, points)) {
      Matrix6d tangent = membrane_tangent(*body_.options.capsule, x * skin.gradients);
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
}

double CapsulePotential::scale_uJ(const VectorXd& /*u_mm*/) const {
  double area_mm2 = 0;
  for (const BoundaryFace& face : body_.boundary) area_mm2 += face.area_mm2;
  return body_.options.capsule->youngs_modulus_kPa * body_.options.capsule->thickness_mm * area_mm2;
}

namespace {

std::vector<SkinPoint> skin_points(const Body& body, const BoundaryFace& face, const std::vector<FacePoint>& points) {
  const FaceNodes rest = rest_nodes(body, face);
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

}  // namespace
}  // namespace glisson::mechanics
