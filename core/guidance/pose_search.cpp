#include "guidance/pose_search.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "guidance/internal/pose_cost.h"
#include "guidance/internal/search_parts.h"
#include "guidance/internal/seen_depths.h"
#include "registration/rigid.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr int attempts = 400000;     // of triples; most are refused by their distances, in nanoseconds
constexpr int maximum_poses = 4000;  // that are scored
constexpr int refined = 12;          // of the best
constexpr std::size_t fewest_points = 5;
constexpr double straight_mm = 8;       // standard deviation across the longest way of all curves
constexpr double min_distance_mm = 25;  // of two points of a triple: nearer ones turn with the noise
constexpr std::size_t scored_points = 80;

// Where nothing but the cloud is known:
constexpr int anchors = 6;                 // places of the seen side that may be the middle of the cloud
constexpr std::size_t begun_turns = 240;   // are refined by points to points until their order can be told,
constexpr std::size_t refined_turns = 32;  // and these of them by points to planes
constexpr int begun_rounds = 12, plane_rounds = 16, curve_rounds = 40;
constexpr std::size_t plane_points = 200;
constexpr double largest_cost_mm = 5;  // of a pose that is answered
constexpr double unseen_weight = 0.5;  // of a cell that should have been seen, beside one that is not explained
constexpr double alike_cost = 1.4;     // of the best, or of the noise: a pose elsewhere that fits as well
constexpr Apart distinct{10, 10}, elsewhere{30, 25};

// Iterated closest points, round by round within a shorter reach.
Isometry3d refined_to_points(const PoseCost& cost, Isometry3d pose, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const auto better = cost.step_to_points(pose, std::max(10.0, 40.0 - 2.0 * round));
    if (!better) return pose;
    pose = *better;
  }
  return pose;
}

Isometry3d refined_to_planes(const PoseCost& cost, Isometry3d pose) {
  for (int round = 0; round < plane_rounds; ++round) {
    const auto better = cost.step_to_planes(pose, std::max(10.0, 20.0 - round));
    if (!better) return pose;
    pose = *better;
  }
  return pose;
}

// A seen point with the curve that it is of.
struct CurvePoint {
  std::size_t curve;
  Vector3d seen_mm;
};

std::vector<Scored> poses_of_triples(const PoseCost& cost, const SeenFrame& frame) {
  std::vector<CurvePoint> points;
  for (std::size_t c = 0; c < frame.curves.size(); ++c) {
    for (const Vector3d& point : frame.curves[c].seen_mm) points.push_back({c, point});
  }
  std::mt19937 random(1);
  const auto any = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
  std::vector<Scored> poses;
  for (int attempt = 0; attempt < attempts && static_cast<int>(poses.size()) < maximum_poses; ++attempt) {
    std::vector<Vector3d> seen(3), at_rest(3);
    for (int k = 0; k < 3; ++k) {
      const CurvePoint& point = points[any(points.size())];
      const auto& curve = frame.curves[point.curve].at_rest_mm;
      seen[k] = point.seen_mm;
      at_rest[k] = curve[any(curve.size())];
    }
    bool alike = true;
    for (int k = 0; k < 3 && alike; ++k) {
      const double apart_mm = (seen[k] - seen[(k + 1) % 3]).norm();
      const double rest_mm = (at_rest[k] - at_rest[(k + 1) % 3]).norm();
      alike = apart_mm > min_distance_mm && std::abs(apart_mm - rest_mm) < 3.0 + 0.08 * apart_mm;
    }
    if (!alike) continue;
    if (const auto pose = registration::align_points(at_rest, seen))
      poses.push_back({cost.of_curves_and_cloud(*pose), *pose});
  }
  return poses;
}

// Middles of triangles that face the camera under the rotation, far from each other.
std::vector<Vector3d> anchors_of(const geometry::Surface& surface, const std::vector<Vector3d>& normals,
                                 const Eigen::Matrix3d& rotation) {
  constexpr double facing = -0.5;  // cosine to the line of sight
  std::vector<Vector3d> among;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if ((rotation * normals[t]).z() < facing) {
      among.push_back(surface.points_mm[static_cast<std::size_t>(surface.triangles[t][0])]);
    }
  }
  std::vector<double> apart(among.size(), std::numeric_limits<double>::infinity());
  std::vector<Vector3d> chosen;
  while (!among.empty() && chosen.size() < anchors) {
    const auto next = static_cast<std::size_t>(std::max_element(apart.begin(), apart.end()) - apart.begin());
    chosen.push_back(among[next]);
    for (std::size_t i = 0; i < among.size(); ++i) apart[i] = std::min(apart[i], (among[i] - chosen.back()).norm());
  }
  return chosen;
}

std::vector<Scored> poses_of_turns(const PoseCost& cost, const geometry::Surface& surface) {
  const Vector3d& mean = cost.cloud_middle_mm();
  const Vector3d middle =
      *std::min_element(cost.cloud_mm().begin(), cost.cloud_mm().end(),
                        [&](const Vector3d& a, const Vector3d& b) { return (a - mean).norm() < (b - mean).norm(); });
  const std::vector<Eigen::Matrix3d> rotations = even_rotations();
  std::vector<std::vector<Scored>> of_rotation(rotations.size());
  parallel_for(rotations.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      for (const Vector3d& anchor : anchors_of(surface, cost.normals(), rotations[r])) {
        Isometry3d pose = Isometry3d::Identity();
        pose.linear() = rotations[r];
        pose.translation() = middle - rotations[r] * anchor;
        of_rotation[r].push_back({cost.of_curves_and_cloud(pose), pose});
      }
    }
  });
  std::vector<Scored> poses;
  for (const auto& some : of_rotation) poses.insert(poses.end(), some.begin(), some.end());
  return poses;
}

// The best so many, no two of them alike: where all the best are one, the second place must not be crowded out.
std::vector<Scored> best_distinct(std::vector<Scored> poses, std::size_t count, const Vector3d& middle_mm) {
  std::sort(poses.begin(), poses.end(), fits_better);
  std::vector<Scored> chosen;
  for (const Scored& pose : poses) {
    if (chosen.size() == count) break;
    const bool is_new = std::all_of(chosen.begin(), chosen.end(), [&](const Scored& other) {
      return lie_apart(pose.pose, other.pose, middle_mm, distinct);
    });
    if (is_new) chosen.push_back(pose);
  }
  return chosen;
}

double cost_with_depths(const PoseCost& cost, const SeenDepths& depths, const geometry::Surface& surface,
                        const Isometry3d& pose) {
  if (!depths.is_picture()) return cost.of_cloud(pose);
  const auto [before, unseen] = depths.contradiction(surface, pose);
  return cost.of_cloud(pose) + far_mm * (before + unseen_weight * std::min(1.0, unseen));
}

// By its shape and by curves that are nearly straight; a smooth organ may lie so in two ways, and then nothing is
// answered.
Result<Isometry3d> find_pose_by_turns(const geometry::Surface& surface, const SeenFrame& frame) {
  const auto refuse = [&](const char* why) {
    return failure(Error{"pose-not-found",
                         why,
                         {frame.id},
                         GLISSON_TEXT("Give a pose_guess, or mark ridges or the falciform ligament."),
                         {}});
  };
  const Vector3d middle = geometry::bounding_box(surface.points_mm).center_mm();
  const PoseCost coarse(surface, frame, scored_points), fine(surface, frame, plane_points);
  const SeenDepths depths(frame.points_mm);
  std::vector<Scored> poses = poses_of_turns(coarse, surface);
  const auto refine_best = [&](std::size_t count, const PoseCost& cost, const auto& refined_pose) {
    poses = best_distinct(std::move(poses), count, middle);
    parallel_for(poses.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        poses[p].pose = refined_pose(cost, poses[p].pose);
        poses[p].cost = cost_with_depths(cost, depths, surface, poses[p].pose) + cost.of_curves(poses[p].pose);
      }
    });
  };
  refine_best(begun_turns, coarse,
              [](const PoseCost& cost, const Isometry3d& pose) { return refined_to_points(cost, pose, begun_rounds); });
  refine_best(refined_turns, fine, refined_to_planes);
  const auto best = std::min_element(poses.begin(), poses.end(), fits_better);
  if (best == poses.end() || best->cost > (frame.curves.empty() ? 1 : 2) * largest_cost_mm) {
    return refuse(GLISSON_TEXT("Under no pose does what frame {0} saw lie near the organ."));
  }
  const bool is_ambiguous = std::any_of(poses.begin(), poses.end(), [&](const Scored& other) {
    return other.cost < alike_cost * std::max(best->cost, frame.noise_mm) &&
           lie_apart(other.pose, best->pose, middle, elsewhere);
  });
  if (is_ambiguous) {
    return refuse(
        GLISSON_TEXT("What frame {0} saw fits the organ in more than one place: its shape alone does not say where."));
  }
  return best->pose;
}

// Triples of their points do, unless they all lie near one straight line.
bool tell_a_pose(const std::vector<SeenCurve>& curves) {
  std::vector<Vector3d> seen;
  for (const SeenCurve& curve : curves) seen.insert(seen.end(), curve.seen_mm.begin(), curve.seen_mm.end());
  if (seen.size() < fewest_points) return false;
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& point : seen) middle += point / static_cast<double>(seen.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : seen) spread += (point - middle) * (point - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread / static_cast<double>(seen.size()),
                                                            Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[1])) > straight_mm;
}

}  // namespace

Result<Isometry3d> find_pose(const geometry::Surface& surface, const SeenFrame& frame) {
  if (!tell_a_pose(frame.curves)) return find_pose_by_turns(surface, frame);
  const PoseCost cost(surface, frame, scored_points);
  std::vector<Scored> poses = poses_of_triples(cost, frame);
  std::sort(poses.begin(), poses.end(), fits_better);
  poses.resize(std::min<std::size_t>(poses.size(), refined));
  for (Scored& pose : poses) {
    pose.pose = refined_to_points(cost, pose.pose, curve_rounds);
    pose.cost = cost.of_curves_and_cloud(pose.pose);
  }
  const auto best = std::min_element(poses.begin(), poses.end(), fits_better);
  if (best == poses.end() || best->cost > far_mm) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("Under no pose does what frame {0} saw lie near the organ."),
                         {frame.id},
                         GLISSON_TEXT("Check that the features have the same names on both sides, that lengths are in "
                                      "mm, and that the frame is of this patient."),
                         {}});
  }
  return best->pose;
}

double unexplained_mm(const geometry::Surface& surface, const SeenFrame& frame, const Isometry3d& pose) {
  return cost_with_depths(PoseCost(surface, frame, plane_points), SeenDepths(frame.points_mm), surface, pose);
}

}  // namespace glisson::guidance
