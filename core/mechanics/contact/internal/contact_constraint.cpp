#include "mechanics/contact/internal/contact_constraint.h"

#include <algorithm>
#include <cmath>

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactConstraint constraint_at(const Body& body, std::size_t tool, std::size_t rod, const ContactPoint& at,
                                double k_kPa_mm, double along_kPa_mm) {
  const ContactPointWeights weights = weights_at(body, at);
  ContactConstraint constraint{tool, rod, at, {}, weights.nodes, weights.values, weights.rest_mm};
  constraint.k_mN_mm = k_kPa_mm * weights.area_mm2;
  constraint.along_mN_mm = along_kPa_mm * weights.area_mm2;
  return constraint;
}

double penalty_stiffness_kPa_mm(double times, const Body& body, const geometry::Surface& surface) {
  const double area_mm2 = geometry::area_mm2(surface) / static_cast<double>(surface.triangles.size());
  return penalty_stiffness_mN_mm(times, body, surface) / area_mm2;
}

double penalty_stiffness_mN_mm(double times, const Body& body, const geometry::Surface& surface) {
  double mean_kPa = 0;
  for (const double youngs : body.youngs_kPa) mean_kPa += youngs / static_cast<double>(body.youngs_kPa.size());
  const double edge_mm =
      std::sqrt(4 / std::sqrt(3.0) * geometry::area_mm2(surface) / static_cast<double>(surface.triangles.size()));
  return times * mean_kPa * edge_mm;
}

Vector3d place_of(const ContactConstraint& constraint, const VectorXd& u_mm) {
  Vector3d at_mm = constraint.rest_mm;
  for (int i = 0; i < 6; ++i) at_mm += constraint.weights[i] * u_mm.segment<3>(3 * constraint.nodes[i]);
  return at_mm;
}

Gap gap_of(const ContactConstraint& constraint, const VectorXd& u_mm) {
  const Vector3d at_mm = place_of(constraint, u_mm);
  const Vector3d axis = constraint.rod.to_mm - constraint.rod.from_mm;
  const double along = axis.squaredNorm() > 0 ? (at_mm - constraint.rod.from_mm).dot(axis) / axis.squaredNorm() : 0.0;
  const Vector3d arm = at_mm - constraint.rod.from_mm - std::clamp(along, 0.0, 1.0) * axis;
  const double distance_mm = std::max(arm.norm(), 1e-9);
  Gap gap{distance_mm - constraint.rod.radius_mm, arm / distance_mm, Matrix3d::Identity()};
  gap.bend -= gap.normal * gap.normal.transpose();
  if (along > 0 && along < 1) gap.bend -= axis * axis.transpose() / axis.squaredNorm();
  gap.bend /= distance_mm;
  return gap;
}

void anchor(ContactConstraint& constraint, const Pose& tool, const VectorXd& u_mm) {
  constraint.from_mm = place_of(constraint, u_mm);
  constraint.from_on_tool_mm = tool.rotation.transpose() * (constraint.from_mm - tool.position_mm);
}

void limit_friction(ContactConstraint& constraint, double normal_mN, const VectorXd& u_mm) {
  constraint.friction_limit_mN = constraint.friction * normal_mN;
  if (constraint.friction_limit_mN == 0) return;
  constraint.normal = gap_of(constraint, u_mm).normal;
  constraint.friction_mN -= constraint.friction_mN.dot(constraint.normal) * constraint.normal;
}

FrictionForce friction_force_of(const ContactConstraint& constraint, const VectorXd& u_mm) {
  if (constraint.friction_limit_mN == 0) return {Vector3d::Zero(), Matrix3d::Zero(), 0.0, true};
  const double k_mN_mm = constraint.along_mN_mm;
  const Matrix3d tangential = Matrix3d::Identity() - constraint.normal * constraint.normal.transpose();
  const Vector3d y = constraint.friction_mN - k_mN_mm * tangential * (place_of(constraint, u_mm) - constraint.from_mm);
  const double maximum = constraint.friction_limit_mN, size = y.norm(), known = constraint.friction_mN.squaredNorm();
  if (size <= maximum) return {y, k_mN_mm * tangential, (size * size - known) / (2 * k_mN_mm), false};
  const Vector3d way = y / size;
  return {maximum * way, k_mN_mm * maximum / size * (tangential - way * way.transpose()),
          (2 * maximum * size - maximum * maximum - known) / (2 * k_mN_mm), true};
}

}  // namespace glisson::mechanics
