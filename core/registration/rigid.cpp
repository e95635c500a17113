#include "registration/rigid.h"

#include <algorithm>
#include <cmath>
#include <Eigen/SVD>

#include "base/parallel.h"
#include "geometry/nearest.h"

namespace glisson::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using geometry::Surface;

constexpr double degenerate = 1e-9;  // second spread over the first, below which points lie on a line

std::vector<Vector3d> thinned(const std::vector<Vector3d>& points_mm, std::size_t maximum) {
  const std::size_t step = std::max<std::size_t>(1, (points_mm.size() + maximum - 1) / maximum);
  std::vector<Vector3d> kept;
  for (std::size_t i = 0; i < points_mm.size(); i += step) kept.push_back(points_mm[i]);
  return kept;
}

// Pairs of a point of the part and its nearest on the whole; `squared_distance_mm2` decides which are kept.
struct Pairs {
  std::vector<Vector3d> part_mm;
  std::vector<Vector3d> whole_mm;
  std::vector<double> squared_distance_mm2;
};

Pairs pair_up(const std::vector<Vector3d>& part_mm, const geometry::SurfaceDistance& whole,
              const Isometry3d& to_whole) {
  Pairs pairs{part_mm, std::vector<Vector3d>(part_mm.size()), std::vector<double>(part_mm.size())};
  parallel_for(part_mm.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto closest = whole.closest(to_whole * part_mm[i]);
      pairs.whole_mm[i] = closest.point_mm;
      pairs.squared_distance_mm2[i] = closest.distance_mm * closest.distance_mm;
    }
  });
  return pairs;
}

// Keeps the nearest pairs; returns the mean squared distance of those.
double trim(Pairs& pairs, double kept_fraction, std::vector<double>& weights) {
  std::vector<double> sorted = pairs.squared_distance_mm2;
  const auto kept = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(kept_fraction * static_cast<double>(sorted.size()))), 1, sorted.size());
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(kept - 1), sorted.end());
  const double limit = sorted[kept - 1];
  weights.assign(sorted.size(), 0.0);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (pairs.squared_distance_mm2[i] > limit) continue;
    weights[i] = 1;
    sum += pairs.squared_distance_mm2[i];
    ++count;
  }
  return sum / count;
}

}  // namespace

Result<Isometry3d> align_points(const std::vector<Vector3d>& from_mm, const std::vector<Vector3d>& to_mm,
                                const std::vector<double>& weights) {
  if (from_mm.size() != to_mm.size() || (!weights.empty() && weights.size() != from_mm.size())) {
    return failure("alignment-sizes", GLISSON_TEXT("{0} points cannot be aligned to {1}."),
                   {std::to_string(from_mm.size()), std::to_string(to_mm.size())});
  }
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  double total = 0;
  std::size_t counted = 0;
  Vector3d from_center = Vector3d::Zero(), to_center = Vector3d::Zero();
  for (std::size_t i = 0; i < from_mm.size(); ++i) {
    total += weight(i);
    counted += weight(i) > 0 ? 1 : 0;
    from_center += weight(i) * from_mm[i];
    to_center += weight(i) * to_mm[i];
  }
  const auto too_few = [] {
    return failure("alignment-too-few-points",
                   GLISSON_TEXT("A rigid alignment needs three pairs of points that do not lie on one line."));
  };
  if (counted < 3) return too_few();
  from_center /= total;
  to_center /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from_mm.size(); ++i) {
    covariance += weight(i) * (from_mm[i] - from_center) * (to_mm[i] - to_center).transpose();
  }
  if (!covariance.allFinite()) {
    return failure("alignment-sizes", GLISSON_TEXT("Some of the points to align are not finite."));
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()[1] <= degenerate * svd.singularValues()[0] || svd.singularValues()[0] == 0) return too_few();
  Eigen::Matrix3d no_reflection = Eigen::Matrix3d::Identity();
  no_reflection(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
  Isometry3d transform = Isometry3d::Identity();
  transform.linear() = svd.matrixV() * no_reflection * svd.matrixU().transpose();
  transform.translation() = to_center - transform.linear() * from_center;
  return transform;
}

Result<RigidIcpResult> rigid_icp(const Surface& source, const Surface& target, const RigidIcpOptions& options,
                                 const Progress& progress) {
  constexpr std::size_t maximum_points = 5000;
  if (auto good = check_surface(source); !good) return failure(good.error());
  if (auto good = check_surface(target); !good) return failure(good.error());
  const bool target_is_part = resolved(options.overlap, source, target) == Overlap::target_is_part;
  const std::vector<Vector3d> part_mm = thinned(target_is_part ? target.points_mm : source.points_mm, maximum_points);
  const geometry::SurfaceDistance whole(target_is_part ? source : target);
  const double reach_mm = geometry::bounding_box(part_mm).diagonal_mm();

  Isometry3d to_whole = Isometry3d::Identity();
  RigidIcpResult result;
  std::vector<double> weights;
  while (result.stopped == IcpStop::not_run) {
    Pairs pairs = pair_up(part_mm, whole, to_whole);
    result.rms_mm = std::sqrt(trim(pairs, options.kept_fraction, weights));
    const auto next = align_points(pairs.part_mm, pairs.whole_mm, weights);
    if (!next) return failure(next.error());
    const Isometry3d step = *next * to_whole.inverse();
    const double step_mm = (step * (to_whole * part_mm.front()) - to_whole * part_mm.front()).norm() +
                           (step.linear() - Eigen::Matrix3d::Identity()).norm() * reach_mm;
    to_whole = *next;
    ++result.iterations;
    progress.report(static_cast<double>(result.iterations) / options.iterations, GLISSON_TEXT("rigid alignment"));
    if (step_mm < options.smallest_step_mm) {
      result.stopped = IcpStop::converged;
    } else if (progress.cancelled()) {
      result.stopped = IcpStop::cancelled;
    } else if (result.iterations >= options.iterations) {
      result.stopped = IcpStop::iterations_used_up;
    }
  }
  result.transform = target_is_part ? to_whole.inverse() : to_whole;
  return result;
}

Overlap resolved(Overlap overlap, const Surface& source, const Surface& target) {
  constexpr double part_of_whole = 0.9;
  if (overlap != Overlap::by_area) return overlap;
  const double source_mm2 = geometry::area_mm2(source);
  const double target_mm2 = geometry::area_mm2(target);
  if (source_mm2 < part_of_whole * target_mm2) return Overlap::source_is_part;
  if (target_mm2 < part_of_whole * source_mm2) return Overlap::target_is_part;
  return Overlap::neither;
}

Surface moved(Surface surface, const Isometry3d& transform) {
  for (Vector3d& point : surface.points_mm) point = transform * point;
  return surface;
}

}  // namespace glisson::registration
