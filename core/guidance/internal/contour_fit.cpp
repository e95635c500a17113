#include "guidance/internal/contour_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "guidance/internal/search_parts.h"
#include "vision/draw.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr std::size_t most_seen = 40, most_at_rest = 60;  // places of a contour that are asked
constexpr double nearest_mm = 20;                         // before the camera
constexpr double back_weight = 0.3;    // of a place at rest that lies in the picture: what is seen of a line is a part
constexpr double along_weight = 0.05;  // of an error along the line, which says nothing but at its ends
constexpr double wide_px = 200, narrow_px = 15;
constexpr int rounds = 30;

using Matrix6d = Eigen::Matrix<double, 6, 6>;

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

}  // namespace

TurningEdges::TurningEdges(const geometry::Surface& organ) : organ_(organ) {
  const auto point = [&](int p) -> const Vector3d& { return organ_.points_mm[static_cast<std::size_t>(p)]; };
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

std::vector<Vector3d> TurningEdges::seen_from(const Vector3d& camera_mm) const {
  const auto point = [&](int p) -> const Vector3d& { return organ_.points_mm[static_cast<std::size_t>(p)]; };
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

ContourFit::ContourFit(const geometry::Surface& organ, const vision::Camera& camera,
                       const std::vector<SeenContour>& contours)
    : turning_(organ),
      focal_px_(0.5 * (camera.matrix(0, 0) + camera.matrix(1, 1))),
      low_(Vector2d::Constant(std::numeric_limits<double>::infinity())),
      high_(-low_) {
  middle_mm_ = geometry::bounding_box(organ.points_mm).center_mm();
  for (const SeenContour& contour : contours) {
    Line line{every_nth(contour.at_rest_mm, most_at_rest), {}, {}};
    line.outwards = normals_around(organ, line.at_rest_mm);
    for (const auto& ray : vision::rays(camera, every_nth(contour.seen_px, most_seen))) {
      if (ray) line.seen.emplace_back(ray->head<2>());
    }
    line_of_.push_back(line.seen.empty() ? std::nullopt : std::optional(lines_.size()));
    if (!line.seen.empty()) lines_.push_back(std::move(line));
  }
  for (const Line& line : lines_) {
    for (const Vector2d& at : line.seen) {
      low_ = low_.cwiseMin(at);
      high_ = high_.cwiseMax(at);
    }
  }
}

std::size_t ContourFit::lines_at_rest() const {
  return static_cast<std::size_t>(
      std::count_if(lines_.begin(), lines_.end(), [](const Line& line) { return !line.at_rest_mm.empty(); }));
}

Isometry3d ContourFit::begun_at(const Eigen::Matrix3d& turn) const {
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

Isometry3d ContourFit::refined(Isometry3d pose) const {
  for (int round = 0; round < rounds; ++round) {
    const double width_px = wide_px * std::pow(narrow_px / wide_px, std::min(1.0, 1.3 * round / rounds));
    Step step;
    const double before = cost(pose, width_px, &step);
    Isometry3d next = moved_about(pose, pose * middle_mm_, step);
    for (int half = 0; half < 4 && cost(next, width_px) > before; ++half)
      next = moved_about(pose, pose * middle_mm_, step *= 0.4);
    if ((next * middle_mm_).z() < nearest_mm) return pose;
    pose = next;
  }
  return pose;
}

double ContourFit::wide_cost(const Isometry3d& pose) const { return cost(pose, wide_px); }

double ContourFit::narrow_cost(const Isometry3d& pose) const { return cost(pose, narrow_px); }

double ContourFit::cost(const Isometry3d& pose, double width_px, Step* step) const {
  const double width = width_px / focal_px_;
  Matrix6d normal = Matrix6d::Zero();
  Step right = Step::Zero();
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

double ContourFit::turned_away(const Isometry3d& pose) const {
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

std::optional<ContourError> ContourFit::error(std::size_t contour, const Isometry3d& pose) const {
  if (!line_of_[contour]) return std::nullopt;
  const Line& line = lines_[*line_of_[contour]];
  const Shown shown = shown_of(line, pose);
  ContourError off;
  if (shown.at.empty())
    return ContourError{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Vector2d& at : line.seen) {
    const Nearest nearest = nearest_to(at, shown.at);
    off.px += focal_px_ * nearest.distance / static_cast<double>(line.seen.size());
    off.mm += nearest.distance * shown.place_mm[nearest.place].z() / static_cast<double>(line.seen.size());
  }
  return off;
}

Eigen::Matrix2d ContourFit::Shown::trusted(std::size_t p) const {
  if (!has_ends || p == 0 || p + 1 == at.size()) return Eigen::Matrix2d::Identity();
  const Vector2d along = (at[p + 1] - at[p - 1]).normalized();
  return Eigen::Matrix2d::Identity() - (1 - along_weight) * along * along.transpose();
}

ContourFit::Shown ContourFit::shown_of(const Line& line, const Isometry3d& pose) const {
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

bool ContourFit::is_within(const Vector2d& at) const {
  return (at.array() >= low_.array()).all() && (at.array() <= high_.array()).all();
}

}  // namespace glisson::guidance
