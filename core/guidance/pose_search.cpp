#include "guidance/pose_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "registration/rigid.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr int attempts = 400000;        // of triples; most are refused by their distances, in nanoseconds
constexpr int maximum_poses = 4000;     // that are scored
constexpr int refined = 12;             // of the best
constexpr double far_mm = 20;           // beyond which a point counts as not explained
constexpr double min_distance_mm = 25;  // of two points of a triple: nearer ones turn with the noise
constexpr std::size_t scored_points = 80;

// Where nothing but the cloud is known:
constexpr int directions = 48, turns = 12;  // that the organ is looked at from, and about the line of sight
constexpr int anchors = 6;                  // places of the seen side that may be the middle of the cloud
constexpr std::size_t begun_turns = 240;    // are refined until their order can be told,
constexpr std::size_t refined_turns = 40;   // and these of them to the end
constexpr int begun_rounds = 12, rounds = 40;
constexpr double alike_score = 1.15;  // of the best: a pose elsewhere that fits as well
constexpr double elsewhere_mm = 30, elsewhere_deg = 25;

struct Scored {
  double score = 0;  // mean distance, none above far_mm
  Isometry3d pose = Isometry3d::Identity();
};

template <typename T>
std::vector<T> every_nth(const std::vector<T>& all, std::size_t maximum) {
  if (all.size() <= maximum) return all;
  std::vector<T> some;
  for (std::size_t i = 0; i < maximum; ++i) some.push_back(all[i * all.size() / maximum]);
  return some;
}

std::vector<Vector3d> normals_of(const geometry::Surface& surface) {
  std::vector<Vector3d> normals;
  const auto point = [&](int i) { return surface.points_mm[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : surface.triangles) {
    normals.push_back((point(b) - point(a)).cross(point(c) - point(a)).normalized());
  }
  return normals;
}

// What a pose is judged by: seen curves beside the curves at rest, seen points beside the surface.
class Judge {
 public:
  Judge(const geometry::Surface& surface, const SeenFrame& frame)
      : surface_(surface), normals_(normals_of(surface)), cloud_mm_(every_nth(frame.points_mm, scored_points)) {
    for (const SeenCurve& curve : frame.curves) {
      curves_.push_back({geometry::NearestPoint(curve.at_rest_mm), every_nth(curve.seen_mm, scored_points)});
    }
  }

  [[nodiscard]] double score(const Isometry3d& pose) const {
    const Isometry3d back = pose.inverse();
    double curves = 0;
    std::size_t seen = 0;
    for (const Curve& curve : curves_) {
      for (const Vector3d& point : curve.seen_mm) {
        curves += std::min(far_mm, std::sqrt(curve.at_rest.nearest(back * point).squared_distance_mm2));
      }
      seen += curve.seen_mm.size();
    }
    return curves / static_cast<double>(std::max<std::size_t>(1, seen)) + score_of_cloud(pose);
  }

  // Of the cloud alone: points that would lie on a side turned away from the camera are not explained either.
  [[nodiscard]] double score_of_cloud(const Isometry3d& pose) const {
    const Isometry3d back = pose.inverse();
    double sum = 0;
    for (const Vector3d& point : cloud_mm_) {
      const auto closest = surface_.closest(back * point);
      const bool is_turned_away = (pose.linear() * normals_[static_cast<std::size_t>(closest.triangle)]).dot(point) > 0;
      sum += is_turned_away ? far_mm : std::min(far_mm, closest.distance_mm);
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, cloud_mm_.size()));
  }
  [[nodiscard]] const std::vector<Vector3d>& cloud_mm() const { return cloud_mm_; }
  [[nodiscard]] const std::vector<Vector3d>& normals() const { return normals_; }  // one a triangle, outwards

  // Pairs of what was seen and what lies nearest to it, those within `reach_mm`.
  void pairs(const Isometry3d& pose, double reach_mm, std::vector<Vector3d>& at_rest, std::vector<Vector3d>& seen,
             std::vector<double>& weights) const {
    const Isometry3d back = pose.inverse();
    const auto add = [&](const Vector3d& rest, const Vector3d& point, double weight) {
      if ((rest - back * point).norm() > reach_mm) return;
      at_rest.push_back(rest);
      seen.push_back(point);
      weights.push_back(weight);
    };
    for (const Curve& curve : curves_) {
      for (const Vector3d& point : curve.seen_mm) {
        const auto nearest = curve.at_rest.nearest(back * point);
        add(curve.at_rest.points_mm()[static_cast<std::size_t>(nearest.point)], point, 2.0);
      }
    }
    for (const Vector3d& point : cloud_mm_) add(surface_.closest(back * point).point_mm, point, 1.0);
  }

 private:
  struct Curve {
    geometry::NearestPoint at_rest;
    std::vector<Vector3d> seen_mm;
  };
  geometry::SurfaceDistance surface_;
  std::vector<Vector3d> normals_;
  std::vector<Curve> curves_;
  std::vector<Vector3d> cloud_mm_;
};

// Iterated closest points, round by round within a shorter reach.
Isometry3d refine(const Judge& judge, Isometry3d pose, int from = 0, int to = rounds) {
  for (int round = from; round < to; ++round) {
    std::vector<Vector3d> at_rest, seen;
    std::vector<double> weights;
    judge.pairs(pose, std::max(10.0, 40.0 - 2.0 * round), at_rest, seen, weights);
    const auto better = registration::align_points(at_rest, seen, weights);
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

std::vector<Scored> poses_of_triples(const Judge& judge, const SeenFrame& frame) {
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
    if (const auto pose = registration::align_points(at_rest, seen)) poses.push_back({judge.score(*pose), *pose});
  }
  return poses;
}

// Rotations spread evenly: where the line of sight points in the organ (Fibonacci's lattice), and how it is turned.
std::vector<Eigen::Matrix3d> even_rotations() {
  std::vector<Eigen::Matrix3d> rotations;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int d = 0; d < directions; ++d) {
    const double z = 1 - (2 * d + 1.0) / directions, across = std::sqrt(1 - z * z);
    const Vector3d sight(across * std::cos(golden * d), across * std::sin(golden * d), z);
    const Eigen::Quaterniond onto = Eigen::Quaterniond::FromTwoVectors(sight, Vector3d::UnitZ());
    for (int t = 0; t < turns; ++t) {
      const Eigen::AngleAxisd about(2 * std::numbers::pi * t / turns, Vector3d::UnitZ());
      rotations.emplace_back(about.toRotationMatrix() * onto.toRotationMatrix());
    }
  }
  return rotations;
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

std::vector<Scored> poses_of_turns(const Judge& judge, const geometry::Surface& surface) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : judge.cloud_mm()) mean += point / static_cast<double>(judge.cloud_mm().size());
  const Vector3d middle =
      *std::min_element(judge.cloud_mm().begin(), judge.cloud_mm().end(),
                        [&](const Vector3d& a, const Vector3d& b) { return (a - mean).norm() < (b - mean).norm(); });
  std::vector<Scored> poses;
  for (const Eigen::Matrix3d& rotation : even_rotations()) {
    for (const Vector3d& anchor : anchors_of(surface, judge.normals(), rotation)) {
      Isometry3d pose = Isometry3d::Identity();
      pose.linear() = rotation;
      pose.translation() = middle - rotation * anchor;
      poses.push_back({judge.score_of_cloud(pose), pose});
    }
  }
  return poses;
}

bool lies_elsewhere(const Isometry3d& pose, const Isometry3d& other, const Vector3d& at_rest_mm) {
  const double turn = Eigen::AngleAxisd(pose.linear().transpose() * other.linear()).angle();
  return (pose * at_rest_mm - other * at_rest_mm).norm() > elsewhere_mm ||
         turn * 180 / std::numbers::pi > elsewhere_deg;
}

// By its shape alone; a smooth organ may lie so in two ways, and then nothing is answered.
Result<Isometry3d> find_pose_of_cloud(const geometry::Surface& surface, const SeenFrame& frame) {
  const auto refuse = [&](const char* why) {
    return failure(Error{"pose-not-found",
                         why,
                         {frame.id},
                         GLISSON_TEXT("Give a pose_guess, or mark ridges or the falciform ligament."),
                         {}});
  };
  const Judge judge(surface, frame);
  std::vector<Scored> poses = poses_of_turns(judge, surface);
  const auto better = [](const Scored& a, const Scored& b) { return a.score < b.score; };
  const auto refine_best = [&](std::size_t count, int from, int to) {
    std::sort(poses.begin(), poses.end(), better);
    poses.resize(std::min(poses.size(), count));
    parallel_for(poses.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        poses[p].pose = refine(judge, poses[p].pose, from, to);
        poses[p].score = judge.score_of_cloud(poses[p].pose);
      }
    });
  };
  refine_best(begun_turns, 0, begun_rounds);
  refine_best(refined_turns, begun_rounds, rounds);
  const auto best = std::min_element(poses.begin(), poses.end(), better);
  if (best == poses.end() || best->score > 0.5 * far_mm) {
    return refuse(GLISSON_TEXT("Under no pose does what frame {0} saw lie near the organ."));
  }
  const Vector3d middle = geometry::bounding_box(surface.points_mm).center_mm();
  const bool is_ambiguous = std::any_of(poses.begin(), poses.end(), [&](const Scored& other) {
    return other.score < alike_score * best->score && lies_elsewhere(other.pose, best->pose, middle);
  });
  if (is_ambiguous) {
    return refuse(
        GLISSON_TEXT("What frame {0} saw fits the organ in more than one place: its shape alone does not say where."));
  }
  return best->pose;
}

}  // namespace

Result<Isometry3d> find_pose(const geometry::Surface& surface, const SeenFrame& frame) {
  std::size_t seen = 0;
  for (const SeenCurve& curve : frame.curves) seen += curve.seen_mm.size();
  if (seen < 5) return find_pose_of_cloud(surface, frame);
  const Judge judge(surface, frame);
  std::vector<Scored> poses = poses_of_triples(judge, frame);
  const auto better = [](const Scored& a, const Scored& b) { return a.score < b.score; };
  std::sort(poses.begin(), poses.end(), better);
  poses.resize(std::min<std::size_t>(poses.size(), refined));
  for (Scored& pose : poses) {
    pose.pose = refine(judge, pose.pose);
    pose.score = judge.score(pose.pose);
  }
  const auto best = std::min_element(poses.begin(), poses.end(), better);
  if (best == poses.end() || best->score > far_mm) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("Under no pose does what frame {0} saw lie near the organ."),
                         {frame.id},
                         GLISSON_TEXT("Check that the features have the same names on both sides, that lengths are in "
                                      "mm, and that the frame is of this patient."),
                         {}});
  }
  return best->pose;
}

}  // namespace glisson::guidance
