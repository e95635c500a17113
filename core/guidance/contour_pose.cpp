#include "guidance/contour_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/parallel.h"
#include "guidance/internal/turns.h"
#include "vision/draw.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// A direction before the camera is (x, y, 1); all distances in the picture are of x and y times the focal length.
constexpr std::size_t most_seen = 40, most_at_rest = 60;  // places of a contour that are asked
constexpr double nearest_mm = 20;                         // before the camera
constexpr double back_weight = 0.3;    // of a place at rest that lies in the picture: what is seen of a line is a part
constexpr double along_weight = 0.05;  // of an error along the line, which says nothing but at its ends
constexpr double wide_px = 200, narrow_px = 15;
constexpr int rounds = 30;
constexpr std::size_t begun = 200;
constexpr double away_weight = 0.5;
constexpr double largest_cost = 0.8;  // of 1: nothing is explained
constexpr double alike = 1.15;        // a pose elsewhere whose cost is at most so many times the best's
constexpr Apart elsewhere{40, 30};

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

template <typename Place>
std::vector<Place> every_few(const std::vector<Place>& places, std::size_t most) {
  std::vector<Place> some;
  const std::size_t count = std::min(most, places.size());
  for (std::size_t n = 0; n < count; ++n) some.push_back(places[n * places.size() / count]);
  return some;
}

// Where a model's place is seen, and how that moves with a place.
struct Projected {
  Vector2d at{0, 0};
  Eigen::Matrix<double, 2, 3> slope;
};

Projected projected(const Vector3d& place_mm) {
  Projected seen;
  seen.at = place_mm.head<2>() / place_mm.z();
  seen.slope << 1 / place_mm.z(), 0, -seen.at.x() / place_mm.z(), 0, 1 / place_mm.z(), -seen.at.y() / place_mm.z();
  return seen;
}

// A contour as it is fitted.
struct Line {
  std::vector<Vector3d> at_rest_mm;  // none: the silhouette
  std::vector<Vector2d> seen;
  std::vector<Vector3d> outwards;  // of the surface around each place at rest, unit
};

// Of the triangles around each place, weighted by their areas.
std::vector<Vector3d> normals_around(const geometry::Surface& organ, const std::vector<Vector3d>& places_mm) {
  constexpr double around_mm = 12;
  std::vector<Vector3d> normals(places_mm.size(), Vector3d::Zero());
  for (const auto& triangle : organ.triangles) {
    const auto corner = [&](int k) -> const Vector3d& {
      return organ.points_mm[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
    };
    const Vector3d middle = (corner(0) + corner(1) + corner(2)) / 3;
    const Vector3d twice_area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (std::size_t p = 0; p < places_mm.size(); ++p) {
      if ((places_mm[p] - middle).squaredNorm() < around_mm * around_mm) normals[p] += twice_area;
    }
  }
  for (Vector3d& normal : normals) normal = normal.norm() > 0 ? normal.normalized() : normal;
  return normals;
}

// The edges at which a surface may turn away, with its normals.
class Turning {
 public:
  explicit Turning(const geometry::Surface& organ) : organ_(organ) {
    std::map<std::pair<int, int>, int> first;  // the triangle of an edge
    for (std::size_t t = 0; t < organ.triangles.size(); ++t) {
      const auto& corners = organ.triangles[t];
      for (int k = 0; k < 3; ++k) {
        const int a = corners[static_cast<std::size_t>(k)], b = corners[static_cast<std::size_t>((k + 1) % 3)];
        const auto [other, is_new] = first.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(t));
        if (!is_new) edges_.push_back({0.5 * (point(a) + point(b)), other->second, static_cast<int>(t)});
      }
    }
  }

  // The middles of the edges between a side that the camera sees and one that it does not.
  [[nodiscard]] std::vector<Vector3d> seen_from(const Vector3d& camera_mm) const {
    std::vector<bool> faces(organ_.triangles.size());
    for (std::size_t t = 0; t < faces.size(); ++t) {
      const auto& [a, b, c] = organ_.triangles[t];
      faces[t] = (point(b) - point(a)).cross(point(c) - point(a)).dot(camera_mm - point(a)) > 0;
    }
    std::vector<Vector3d> middles;
    for (const Edge& edge : edges_) {
      if (faces[static_cast<std::size_t>(edge.left)] != faces[static_cast<std::size_t>(edge.right)]) {
        middles.push_back(edge.middle_mm);
      }
    }
    return middles;
  }

 private:
  struct Edge {
    Vector3d middle_mm;
    int left, right;
  };
  [[nodiscard]] const Vector3d& point(int p) const { return organ_.points_mm[static_cast<std::size_t>(p)]; }

  const geometry::Surface& organ_;
  std::vector<Edge> edges_;
};

struct Nearest {
  std::size_t place = 0;
  double distance = std::numeric_limits<double>::infinity();
};

Nearest nearest_to(const Vector2d& at, const std::vector<Vector2d>& places) {
  Nearest nearest;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const double distance = (places[p] - at).squaredNorm();
    if (distance < nearest.distance) nearest = {p, distance};
  }
  nearest.distance = std::sqrt(nearest.distance);
  return nearest;
}

// Lines of a model under a pose, against what was seen of them.
class Fit {
 public:
  Fit(const geometry::Surface& organ, const vision::Camera& camera, const std::vector<SeenContour>& contours)
      : turning_(organ), focal_px_(0.5 * (camera.matrix(0, 0) + camera.matrix(1, 1))) {
    middle_mm_ = geometry::bounding_box(organ.points_mm).center_mm();
    for (const SeenContour& contour : contours) {
      Line line{every_few(contour.at_rest_mm, most_at_rest), {}, {}};
      line.outwards = normals_around(organ, line.at_rest_mm);
      for (const auto& ray : vision::rays(camera, every_few(contour.seen_px, most_seen))) {
        if (ray) line.seen.emplace_back(ray->head<2>());
      }
      if (!line.seen.empty()) lines_.push_back(std::move(line));
    }
    for (const Line& line : lines_) {
      for (const Vector2d& at : line.seen) {
        low_ = low_.cwiseMin(at);
        high_ = high_.cwiseMax(at);
      }
    }
  }

  [[nodiscard]] const Vector3d& middle_mm() const { return middle_mm_; }
  [[nodiscard]] std::size_t lines_at_rest() const {
    return static_cast<std::size_t>(
        std::count_if(lines_.begin(), lines_.end(), [](const Line& line) { return !line.at_rest_mm.empty(); }));
  }

  // Turned so, as far away as the lines look large, with their middle where they are seen.
  [[nodiscard]] Isometry3d begun_at(const Eigen::Matrix3d& turn) const {
    std::vector<Vector3d> rest;
    std::vector<Vector2d> seen;
    for (const Line& line : lines_) {
      if (line.at_rest_mm.empty()) continue;
      rest.insert(rest.end(), line.at_rest_mm.begin(), line.at_rest_mm.end());
      seen.insert(seen.end(), line.seen.begin(), line.seen.end());
    }
    Vector3d rest_middle = Vector3d::Zero();
    Vector2d seen_middle = Vector2d::Zero();
    for (const Vector3d& place : rest) rest_middle += place / static_cast<double>(rest.size());
    for (const Vector2d& at : seen) seen_middle += at / static_cast<double>(seen.size());
    double rest_spread = 0, seen_spread = 0;
    for (const Vector3d& place : rest) rest_spread += (turn * (place - rest_middle)).head<2>().squaredNorm();
    for (const Vector2d& at : seen) seen_spread += (at - seen_middle).squaredNorm();
    rest_spread = std::sqrt(rest_spread / static_cast<double>(rest.size()));
    seen_spread = std::sqrt(seen_spread / static_cast<double>(seen.size()));
    const double depth_mm = std::clamp(rest_spread / std::max(seen_spread, 1e-3), 40.0, 1000.0);
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = turn;
    pose.translation() = depth_mm * Vector3d(seen_middle.x(), seen_middle.y(), 1) - turn * rest_middle;
    return pose;
  }

  // 0: all lies where it was seen; 1: nothing does. With a step that makes it less, where one is asked for.
  [[nodiscard]] double cost(const Isometry3d& pose, double width_px, Vector6d* step = nullptr) const {
    const double width = width_px / focal_px_;
    Matrix6d normal = Matrix6d::Zero();
    Vector6d right = Vector6d::Zero();
    const Vector3d about_mm = pose * middle_mm_;
    double sum = 0;
    for (const Line& line : lines_) {
      const Shown shown = shown_of(line, pose);
      double forward = 0, back = 0;
      const auto add = [&](const Vector2d& seen, std::size_t place, double share) {
        const Vector2d off = seen - shown.at[place];
        const double squared = off.squaredNorm(), weighted = squared / (squared + width * width);
        if (step != nullptr) {
          const Projected moved = projected(shown.place_mm[place]);
          Eigen::Matrix<double, 2, 6> rows;
          rows.leftCols<3>() = moved.slope;
          const Vector3d arm = shown.place_mm[place] - about_mm;
          Eigen::Matrix3d cross;
          cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
          rows.rightCols<3>() = -moved.slope * cross;
          const double weight = share * std::pow(width * width / (squared + width * width), 2) / (width * width);
          const Eigen::Matrix2d trusted = shown.trusted(place);
          normal += weight * rows.transpose() * trusted * rows;
          right += weight * rows.transpose() * trusted * off;
        }
        return weighted;
      };
      if (shown.at.empty()) {
        sum += 1;
        continue;
      }
      const double share = 1.0 / static_cast<double>(line.seen.size());
      for (const Vector2d& at : line.seen) forward += share * add(at, nearest_to(at, shown.at).place, share);
      if (!line.at_rest_mm.empty()) {
        std::size_t within = 0;
        for (const Vector2d& at : shown.at) within += is_within(at) ? 1 : 0;
        const double back_share = back_weight / static_cast<double>(std::max<std::size_t>(1, within));
        for (std::size_t p = 0; p < shown.at.size(); ++p) {
          if (is_within(shown.at[p])) {
            back += back_share * add(line.seen[nearest_to(shown.at[p], line.seen).place], p, back_share);
          }
        }
      }
      sum += (forward + back) / (line.at_rest_mm.empty() ? 1 : 1 + back_weight);
    }
    if (step != nullptr) {
      const double damping = 1e-3 * normal.trace() / 6 + 1e-12;
      normal.diagonal().head<3>().array() += damping * 1e-3;
      normal.diagonal().tail<3>().array() += damping;
      *step = normal.ldlt().solve(right);
      *step *= std::min({1.0, 0.3 / std::max(step->tail<3>().norm(), 1e-12),
                         0.3 * about_mm.z() / std::max(step->head<3>().norm(), 1e-12)});
    }
    return sum / static_cast<double>(lines_.size());
  }

  // The share of the lines that would lie on a side turned away from the camera: what is seen does not.
  [[nodiscard]] double turned_away(const Isometry3d& pose) const {
    constexpr double away = 0.2;  // cosine to the line of sight: a ridge is where the surface turns away
    double sum = 0;
    for (const Line& line : lines_) {
      std::size_t asked = 0, hidden = 0;
      for (std::size_t p = 0; p < line.at_rest_mm.size(); ++p) {
        const Vector3d place = pose * line.at_rest_mm[p];
        if (place.z() < nearest_mm || !is_within(place.head<2>() / place.z())) continue;
        ++asked;
        hidden += (pose.linear() * line.outwards[p]).dot(place.normalized()) > away ? 1 : 0;
      }
      if (asked > 0) sum += static_cast<double>(hidden) / static_cast<double>(asked);
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, lines_at_rest()));
  }

  [[nodiscard]] Isometry3d refined(Isometry3d pose) const {
    for (int round = 0; round < rounds; ++round) {
      const double width_px = wide_px * std::pow(narrow_px / wide_px, std::min(1.0, 1.3 * round / rounds));
      Vector6d step;
      const double before = cost(pose, width_px, &step);
      Isometry3d next = moved(pose, step);
      for (int half = 0; half < 4 && cost(next, width_px) > before; ++half) next = moved(pose, step *= 0.4);
      if ((next * middle_mm_).z() < nearest_mm) return pose;
      pose = next;
    }
    return pose;
  }

  [[nodiscard]] ContourError error(const Line& line, const Isometry3d& pose) const {
    const Shown shown = shown_of(line, pose);
    ContourError off;
    if (shown.at.empty()) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Vector2d& at : line.seen) {
      const Nearest nearest = nearest_to(at, shown.at);
      off.px += focal_px_ * nearest.distance / static_cast<double>(line.seen.size());
      off.mm += nearest.distance * shown.place_mm[nearest.place].z() / static_cast<double>(line.seen.size());
    }
    return off;
  }
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

 private:
  // A line's places before the camera.
  struct Shown {
    std::vector<Vector3d> place_mm;
    std::vector<Vector2d> at;
    bool has_ends = false;

    // Across the line what is off counts, along it hardly, but at its ends.
    [[nodiscard]] Eigen::Matrix2d trusted(std::size_t p) const {
      if (!has_ends || p == 0 || p + 1 == at.size()) return Eigen::Matrix2d::Identity();
      const Vector2d along = (at[p + 1] - at[p - 1]).normalized();
      return Eigen::Matrix2d::Identity() - (1 - along_weight) * along * along.transpose();
    }
  };

  [[nodiscard]] Shown shown_of(const Line& line, const Isometry3d& pose) const {
    Shown shown;
    shown.has_ends = !line.at_rest_mm.empty();
    const std::vector<Vector3d> places =
        line.at_rest_mm.empty() ? turning_.seen_from(pose.inverse().translation()) : line.at_rest_mm;
    for (const Vector3d& at_rest : places) {
      const Vector3d place = pose * at_rest;
      if (place.z() < nearest_mm) continue;
      shown.place_mm.push_back(place);
      shown.at.emplace_back(place.head<2>() / place.z());
    }
    return shown;
  }

  [[nodiscard]] bool is_within(const Vector2d& at) const {
    return (at.array() >= low_.array()).all() && (at.array() <= high_.array()).all();
  }

  [[nodiscard]] Isometry3d moved(const Isometry3d& pose, const Vector6d& step) const {
    const Vector3d about_mm = pose * middle_mm_;
    const double angle = step.tail<3>().norm();
    Isometry3d next = Isometry3d::Identity();
    next.translate(about_mm + step.head<3>());
    if (angle > 0) next.rotate(Eigen::AngleAxisd(angle, step.tail<3>() / angle));
    next.translate(-about_mm);
    return next * pose;
  }

  Turning turning_;
  double focal_px_;
  Vector3d middle_mm_{0, 0, 0};
  std::vector<Line> lines_;
  // Where anything was seen.
  Vector2d low_ = Vector2d::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
};

struct Scored {
  double cost = 0;
  Isometry3d pose = Isometry3d::Identity();
};
bool costs_less(const Scored& a, const Scored& b) { return a.cost < b.cost; }

// A laparoscope enters through the front of the belly: it looks backwards or upwards (the scan's axes are LPS).
bool looks_from_the_belly(const Eigen::Matrix3d& turn) {
  const Vector3d sight = turn.transpose() * Vector3d::UnitZ();
  return sight.y() + sight.z() > 0;
}

std::vector<Scored> from_all_turns(const Fit& fit) {
  std::vector<Scored> poses;
  for (const Eigen::Matrix3d& turn : even_rotations()) {
    if (!looks_from_the_belly(turn)) continue;
    const Isometry3d pose = fit.begun_at(turn);
    poses.push_back({fit.cost(pose, wide_px), pose});
  }
  std::sort(poses.begin(), poses.end(), costs_less);
  poses.resize(std::min(poses.size(), begun));
  parallel_for(poses.size(), 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      poses[p].pose = fit.refined(poses[p].pose);
      poses[p].cost = fit.cost(poses[p].pose, narrow_px) + away_weight * fit.turned_away(poses[p].pose);
    }
  });
  std::erase_if(poses, [](const Scored& each) { return !looks_from_the_belly(each.pose.linear()); });
  std::sort(poses.begin(), poses.end(), costs_less);
  return poses;
}

}  // namespace

Result<ContourPose> pose_of_contours(const geometry::Surface& organ, const vision::Camera& camera,
                                     const std::vector<SeenContour>& contours, const std::optional<Isometry3d>& guess) {
  const Fit fit(organ, camera, contours);
  if (!guess && fit.lines_at_rest() < 2) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("One picture tells a pose by two lines of the organ and more; {0} are given."),
                         {std::to_string(fit.lines_at_rest())},
                         GLISSON_TEXT("Mark ridges and the falciform ligament, or give a pose_guess."),
                         {}});
  }
  std::vector<Scored> poses;
  if (guess) {
    poses.push_back({0, fit.refined(*guess)});
    poses.back().cost = fit.cost(poses.back().pose, narrow_px);
  } else {
    poses = from_all_turns(fit);
  }
  if (poses.empty() || poses.front().cost > largest_cost) {
    return failure(
        Error{"pose-not-found",
              GLISSON_TEXT("Under no pose do the lines of the organ lie on those of the picture."),
              {},
              GLISSON_TEXT("Check that lines have the same names on both sides, that lengths are in mm, and that "
                           "the picture is of this camera and patient."),
              {}});
  }
  const Scored& best = poses.front();
  const bool is_ambiguous = std::any_of(poses.begin(), poses.end(), [&](const Scored& other) {
    return other.cost < alike * best.cost && lie_apart(other.pose, best.pose, fit.middle_mm(), elsewhere);
  });
  if (is_ambiguous) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("The lines of the picture fit the organ in more than one place."),
                         {},
                         GLISSON_TEXT("Mark another line, or give a pose_guess."),
                         {}});
  }
  ContourPose found{best.pose, {}};
  for (const SeenContour& contour : contours) {
    found.off.push_back(error_of(contour, organ, camera, best.pose));
  }
  return found;
}

std::optional<ContourError> error_of(const SeenContour& contour, const geometry::Surface& organ,
                                     const vision::Camera& camera, const Isometry3d& pose) {
  const Fit fit(organ, camera, {contour});
  if (fit.lines().empty()) return std::nullopt;
  return fit.error(fit.lines().front(), pose);
}

}  // namespace glisson::guidance
