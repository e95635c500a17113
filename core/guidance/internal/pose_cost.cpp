#include "guidance/internal/pose_cost.h"

#include <algorithm>
#include <cmath>

#include "guidance/internal/search_parts.h"
#include "registration/rigid.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double weight_of_curves = 2.0;  // of a point of a curve beside one of the cloud
constexpr double cauchy_mm = 3.0;         // that a point off by is half trusted
constexpr std::size_t min_step_points = 10;
// Of a step, so that what a smooth cloud does not tell stays: per point, beside the 1 that a normal has along itself.
constexpr double damping = 1e-3, lever_mm = 20;
constexpr double longest_turn = 0.2;  // rad, within which a step is linear enough

std::vector<Vector3d> normals_of(const geometry::Surface& surface) {
  std::vector<Vector3d> normals;
  const auto point = [&](int i) { return surface.points_mm[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : surface.triangles) {
    normals.push_back((point(b) - point(a)).cross(point(c) - point(a)).normalized());
  }
  return normals;
}

}  // namespace

PoseCost::PoseCost(const geometry::Surface& surface, const SeenFrame& frame, std::size_t maximum_points)
    : surface_(surface), normals_(normals_of(surface)), cloud_mm_(every_nth(frame.points_mm, maximum_points)) {
  for (const SeenCurve& curve : frame.curves) {
    curves_.push_back({geometry::NearestPoint(curve.at_rest_mm), every_nth(curve.seen_mm, maximum_points)});
  }
  for (const Vector3d& point : cloud_mm_) middle_mm_ += point / static_cast<double>(cloud_mm_.size());
}

double PoseCost::of_curves(const Isometry3d& pose) const {
  const Isometry3d back = pose.inverse();
  double curves = 0;
  std::size_t seen = 0;
  for (const Curve& curve : curves_) {
    for (const Vector3d& point : curve.seen_mm) {
      curves += std::min(far_mm, std::sqrt(curve.at_rest.nearest(back * point).squared_distance_mm2));
    }
    seen += curve.seen_mm.size();
  }
  return curves / static_cast<double>(std::max<std::size_t>(1, seen));
}

bool PoseCost::is_turned_away(const Isometry3d& pose, int triangle, const Vector3d& seen_mm) const {
  return (pose.linear() * normals_[static_cast<std::size_t>(triangle)]).dot(seen_mm) > 0;
}

double PoseCost::of_cloud(const Isometry3d& pose) const {
  const Isometry3d back = pose.inverse();
  double sum = 0;
  for (const Vector3d& point : cloud_mm_) {
    const auto closest = surface_.closest(back * point);
    sum += is_turned_away(pose, closest.triangle, point) ? far_mm : std::min(far_mm, closest.distance_mm);
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, cloud_mm_.size()));
}

std::optional<Isometry3d> PoseCost::step_to_points(const Isometry3d& pose, double reach_mm) const {
  const Isometry3d back = pose.inverse();
  std::vector<Vector3d> at_rest, seen;
  std::vector<double> weights;
  const auto add = [&](const Vector3d& rest, const Vector3d& point, double weight) {
    if ((rest - back * point).norm() > reach_mm) return;
    at_rest.push_back(rest);
    seen.push_back(point);
    weights.push_back(weight);
  };
  for (const Curve& curve : curves_) {
    for (const Vector3d& point : curve.seen_mm) {
      const auto nearest = curve.at_rest.nearest(back * point);
      add(curve.at_rest.points_mm()[static_cast<std::size_t>(nearest.point)], point, weight_of_curves);
    }
  }
  for (const Vector3d& point : cloud_mm_) add(surface_.closest(back * point).point_mm, point, 1.0);
  const auto aligned = registration::align_points(at_rest, seen, weights);
  return aligned ? std::optional(*aligned) : std::nullopt;
}

std::optional<Isometry3d> PoseCost::step_to_planes(const Isometry3d& pose, double reach_mm) const {
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  const Isometry3d back = pose.inverse();
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  std::size_t used = 0;
  const auto add = [&](const Vector3d& place, const Vector3d& normal, const Vector3d& point, double weight) {
    const double off_mm = (point - place).dot(normal);
    weight /= 1 + std::pow(off_mm / cauchy_mm, 2);
    Vector6d row;
    row << normal, (place - middle_mm_).cross(normal);
    normal_matrix += weight * row * row.transpose();
    right += weight * off_mm * row;
  };
  for (const Curve& curve : curves_) {
    for (const Vector3d& point : curve.seen_mm) {
      const auto nearest = curve.at_rest.nearest(back * point);
      const Vector3d place = pose * curve.at_rest.points_mm()[static_cast<std::size_t>(nearest.point)];
      if ((point - place).norm() > reach_mm) continue;
      for (int axis = 0; axis < 3; ++axis) add(place, Vector3d::Unit(axis), point, weight_of_curves);
    }
  }
  for (const Vector3d& point : cloud_mm_) {
    const auto closest = surface_.closest(back * point);
    if (closest.distance_mm > reach_mm || is_turned_away(pose, closest.triangle, point)) continue;
    add(pose * closest.point_mm, pose.linear() * normals_[static_cast<std::size_t>(closest.triangle)], point, 1);
    ++used;
  }
  if (used < min_step_points) return std::nullopt;
  const double added = damping * static_cast<double>(used);
  normal_matrix.diagonal().head<3>().array() += added;
  normal_matrix.diagonal().tail<3>().array() += added * lever_mm * lever_mm;
  Vector6d step = normal_matrix.ldlt().solve(right);
  step *= std::min(1.0, longest_turn / std::max(step.tail<3>().norm(), 1e-12));
  return moved_about(pose, middle_mm_, step);
}

}  // namespace glisson::guidance
