#include "guidance/internal/organ_fit.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "guidance/internal/seen_surface.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double share_to_full_forces = 0.6;  // of the elastic rounds
// How far a feature may lie off, median of its points. Of simulated livers right ones lay off by 5 mm at most, with
// names exchanged by 13 mm at least.
constexpr double contradicting_mm = 10, contradicting_noises = 5;

}  // namespace

OrganFit::OrganFit(const ForceModes& the_modes, const SeenFrame& the_frame, const Isometry3d& from,
                   const Vector3d& gravity_mm_s2, const RegistrationOptions& the_options)
    : modes(the_modes),
      frame(the_frame),
      options(the_options),
      equations(the_modes, the_frame, the_options),
      guess(from),
      pose(from),
      further_mm(the_modes.displacement_mm().rows(), 0) {
  at_rest_mm = gravity_mm_s2.isZero() && !modes.is_supported() ? VectorXd::Zero(modes.displacement_mm().rows())
                                                               : modes.known_mm(gravity_mm_s2);
  known_mm = at_rest_mm;
  u_mm = known_mm;
}

std::vector<Vector3d> OrganFit::displaced() const {
  std::vector<Vector3d> points = modes.mesh().points_mm;
  for (std::size_t p = 0; p < points.size(); ++p) points[p] += u_mm.segment<3>(3 * static_cast<Eigen::Index>(p));
  return points;
}

// ---- The rounds ----

void OrganFit::move_pose(const Vector3d& shift_mm, const Vector3d& turn) {
  const double angle = turn.norm();
  const Vector3d center = modes.centroid_mm();
  Isometry3d motion = Isometry3d::Identity();
  if (angle > 0) motion.rotate(Eigen::AngleAxisd(angle, turn / angle));
  motion.translation() = center + shift_mm - motion.linear() * center;
  pose = pose * motion;
}

void OrganFit::fit_pose() {
  const MatrixXd none(u_mm.size(), 0);
  const std::vector<Vector3d> now_mm = displaced();
  const SeenSurface surface(modes.surface(), modes.mesh_point_of(), now_mm);
  for (int round = 0; round < options.rigid_rounds; ++round) {
    seen = equations.rows(pose, now_mm, surface,
                          {.coarsest_mm = 1.5 + 10.0 * (1.0 - static_cast<double>(round) / options.rigid_rounds)});
    VectorXd right = equations.residuals(seen.rows, u_mm);
    const MatrixXd columns = equations.free_columns(seen.rows, {none}, guess.inverse() * pose, 1.0, right);
    const Eigen::Matrix<double, 6, 6> normal = columns.transpose() * columns;
    const Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(columns.transpose() * right);
    move_pose(step.head<3>(), step.tail<3>());
  }
}

double OrganFit::largest_variance(int round) const {
  const double opened = std::min(1.0, (round + 1.0) / (share_to_full_forces * options.elastic_rounds));
  return std::pow(options.largest_rms_mm * opened, 2);
}

void OrganFit::follow(EvidenceFit found) {
  fit = std::move(found);
  const VectorXd amounts = mixing.size() > 0 ? VectorXd(mixing * fit.modes) : fit.modes;
  u_mm = known_mm + basis_mm * amounts + further_mm * fit.free.tail(further_mm.cols());
  move_pose(fit.free.head<3>(), fit.free.segment<3>(3));
}

VectorXd OrganFit::factors_by_what_is_seen(double seen_root) const {
  const geometry::NearestPoint nearest = seen_in_scan();
  VectorXd factors = VectorXd::Ones(modes.displacement_mm().cols());
  for (std::size_t k = 0; k < modes.centers_mm().size(); ++k) {
    const double away_mm = std::sqrt(nearest.nearest(modes.centers_mm()[k]).squared_distance_mm2);
    if (away_mm < options.seen_within_mm) factors.segment<3>(3 * static_cast<Eigen::Index>(k)).setConstant(seen_root);
  }
  return factors;
}

MatrixXd OrganFit::mixed(MatrixXd of_basis) const {
  if (mixing.size() == 0) return of_basis;
  return of_basis * mixing;
}

MatrixXd OrganFit::mode_columns(Eigen::Index free) const {
  return mixed(SeenEquations::mode_columns(seen.rows, basis_mm, free));
}

// ---- What came of it ----

Eigen::Matrix<double, 3, Eigen::Dynamic> OrganFit::columns_at(const mechanics::PointInMesh& place) const {
  const Eigen::Index q = mode_count(), others = further_mm.cols();
  MatrixXd of_basis = MatrixXd::Zero(3, basis_mm.cols());
  Eigen::Matrix<double, 3, Eigen::Dynamic> columns = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, q + 6 + others);
  const auto& cell = modes.mesh().cells[static_cast<std::size_t>(place.cell)];
  Vector3d arm_mm = -modes.centroid_mm();
  for (int k = 0; k < 4; ++k) {
    of_basis += place.barycentric[k] * basis_mm.middleRows<3>(3 * cell[k]);
    columns.rightCols(others) += place.barycentric[k] * further_mm.middleRows<3>(3 * cell[k]);
    arm_mm += place.barycentric[k] *
              (modes.mesh().points_mm[static_cast<std::size_t>(cell[k])] + u_mm.segment<3>(3 * cell[k]));
  }
  columns.leftCols(q) = mixed(std::move(of_basis));
  columns.block<3, 3>(0, q).setIdentity();
  for (int axis = 0; axis < 3; ++axis) columns.block<3, 1>(0, q + 3 + axis) = Vector3d::Unit(axis).cross(arm_mm);
  return columns;
}

// The cloud, brought back to the scan's frame.
geometry::NearestPoint OrganFit::seen_in_scan() const {
  std::vector<Vector3d> seen_mm;
  const Isometry3d back = pose.inverse();
  for (const Vector3d& point : equations.cloud_mm()) seen_mm.push_back(back * point);
  return geometry::NearestPoint(std::move(seen_mm));
}

double OrganFit::visible_share(const geometry::NearestPoint& cloud, const std::vector<Vector3d>& now_mm) const {
  std::size_t visible = 0;
  for (const int p : modes.mesh_point_of()) {
    const auto found = cloud.nearest(now_mm[static_cast<std::size_t>(p)]);
    if (found.squared_distance_mm2 < 100) ++visible;
  }
  return static_cast<double>(visible) / static_cast<double>(std::max<std::size_t>(1, modes.mesh_point_of().size()));
}

// Why this is no answer; without text where it is one.
Sentence OrganFit::what_contradicts(double visible_share) const {
  if (visible_share < 0.05) {
    return {GLISSON_TEXT("Less than 5 % of the organ is seen: too little to say where the rest is."), {}};
  }
  if (seen.trusted_share < 0.5 || seen.rms_mm > 3 * seen.noise_mm) {
    return {GLISSON_TEXT("What is seen does not fit this organ: more than half of the points lie far from it."), {}};
  }
  for (std::size_t c = 0; c < seen.curve_off_mm.size(); ++c) {
    const SeenCurve& curve = frame.curves[c];
    if (seen.curve_off_mm[c] <= std::max(contradicting_mm, contradicting_noises * curve.noise_mm)) continue;
    return {GLISSON_TEXT("The feature {0} lies {1} mm from where all else that is seen has it: the features contradict "
                         "each other or the cloud. Is each named rightly?"),
            {curve.id, fmt::format("{:.0f}", seen.curve_off_mm[c])}};
  }
  return {};
}

ElasticPlacement OrganFit::outcome(const std::vector<mechanics::PointInMesh>& targets, const SpreadRule& rule,
                                   const AskedTools& asked) const {
  ElasticPlacement placed;
  placed.pose = pose;
  const std::vector<Vector3d> now_mm = displaced();
  double square = 0;
  for (const int p : modes.mesh_point_of()) square += u_mm.segment<3>(3 * p).squaredNorm();
  placed.elastic_rms_mm = std::sqrt(square / static_cast<double>(modes.mesh_point_of().size()));
  for (std::size_t p = 0; p < now_mm.size(); ++p) {
    placed.displacement_mm.push_back(now_mm[p] - modes.mesh().points_mm[p]);
  }
  placed.residual_rms_mm = seen.rms_mm;
  const geometry::NearestPoint cloud = seen_in_scan();
  placed.visible_share = visible_share(cloud, now_mm);
  const MatrixXd covariance = fit.covariance();
  for (const mechanics::PointInMesh& place : targets) {
    const auto& cell = modes.mesh().cells[static_cast<std::size_t>(place.cell)];
    const Vector3d here_mm = between(now_mm, cell, place.barycentric);
    placed.target_mm.push_back(pose * here_mm);
    const auto columns = columns_at(place);
    const double posterior_mm = std::sqrt((columns * covariance * columns.transpose()).trace() / 3);
    const double depth_mm = std::sqrt(cloud.nearest(here_mm).squared_distance_mm2);
    const double elastic_share = rule.elastic_share + rule.elastic_share_of_depth * depth_mm;
    placed.target_sd_mm.push_back(std::hypot(rule.posterior_factor * posterior_mm,
                                             elastic_share * placed.elastic_rms_mm,
                                             rule.smallest_sd_mm + rule.share_of_depth * depth_mm));
  }
  for (std::size_t t = 0; t < asked.tools.size(); ++t) {
    const auto first = 6 + 3 * static_cast<Eigen::Index>(t);
    const Eigen::Index in_covariance = mode_count() + first;
    const double variance = covariance.block<3, 3>(in_covariance, in_covariance).trace() / 3;
    const Vector3d force_mN = asked.unit_mN * (pose.linear() * fit.free.segment<3>(first));
    const double posterior_mN = asked.sd_factor * asked.unit_mN * std::sqrt(variance);
    placed.tools.push_back({asked.tools[t], force_mN, std::hypot(posterior_mN, asked.wrong_share * force_mN.norm())});
  }
  placed.why_not = what_contradicts(placed.visible_share);
  placed.converged = placed.why_not.text.empty();
  return placed;
}

}  // namespace glisson::guidance
