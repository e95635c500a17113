#include "mechanics/contact/internal/contact_points.h"

#include <algorithm>
#include <Eigen/Geometry>

#include "mechanics/contact/internal/contact_candidates.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int finest = 3;

// Barycentric, of each fineness in turn.
struct Rule {
  std::vector<Vector3d> points;
  std::array<int, finest + 2> begin;
};
const Rule& rule();
// Enough that a rod lies no deeper than that between the points of a face with such edges.
int fineness(double edge_mm, double radius_mm, double deepest_between_mm);

using FaceValues = Eigen::Matrix<double, 6, 1>;
FaceValues values_at(ElementOrder order, int point);

struct Box {
  Vector3d low, high;

  [[nodiscard]] bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
  }
};

struct MovedFace {
  int number;
  Eigen::Matrix<double, 3, 6> nodes_mm;
  Vector3d outward;
  Box box;
  double edge_mm;
};
std::vector<MovedFace> faces_around(const Body& body, const ToolShape& rods, const VectorXd& u_mm, double margin_mm);
Box box_of(const Rod& rod, double margin_mm);
Vector3d arm_of(const Rod& rod, const Vector3d& at_mm);

}  // namespace

ContactPointWeights weights_at(const Body& body, const ContactPoint& at) {
  const BoundaryFace& face = body.boundary[static_cast<std::size_t>(at.face)];
  ContactPointWeights weights{face.nodes, values_at(body.layout.order, at.point), Vector3d::Zero(), face.area_mm2};
  if (body.layout.order == ElementOrder::linear) {
    std::fill(weights.nodes.begin() + 3, weights.nodes.end(), face.nodes[0]);
  }
  for (int n = 0; n < 6; ++n) weights.rest_mm += weights.values[n] * body.layout.positions_mm[weights.nodes[n]];
  int level = 0;
  while (at.point >= rule().begin[level + 1]) ++level;
  weights.area_mm2 /= rule().begin[level + 1] - rule().begin[level];
  return weights;
}

std::vector<NearPoint> points_near(const Body& body, const std::vector<ContactTool>& tools, const VectorXd& advance_mm,
                                   const VectorXd& u_mm, double margin_mm, double deepest_between_mm) {
  std::vector<NearPoint> near;
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const auto* tool = std::get_if<TouchingTool>(&tools[t].what);
    if (tool == nullptr) continue;
    const ToolShape rods = placed(tool->shape, tool->pose.advanced(advance_mm[static_cast<Eigen::Index>(t)]));
    for (const MovedFace& face : faces_around(body, rods, u_mm, margin_mm)) {
      std::vector<std::pair<int, Vector3d>> seen;  // of this face, with the normal
      for (std::size_t r = 0; r < rods.size(); ++r) {
        if (!face.box.meets(box_of(rods[r], margin_mm))) continue;
        const int level = fineness(face.edge_mm, rods[r].radius_mm, deepest_between_mm);
        for (int p = rule().begin[level]; p < rule().begin[level + 1]; ++p) {
          const Vector3d arm = arm_of(rods[r], face.nodes_mm * values_at(body.layout.order, p));
          const double distance_mm = arm.norm();
          if (distance_mm > rods[r].radius_mm + margin_mm) continue;
          // A tool lies outside: what faces away from it is the far side of the body, and is not touched.
          const Vector3d normal = distance_mm > 1e-9 ? Vector3d(arm / distance_mm) : Vector3d(-face.outward);
          if (normal.dot(face.outward) > 0.2) continue;
          // Rods that meet where they are nearest to it are one.
          const bool known = std::any_of(seen.begin(), seen.end(), [&](const auto& other) {
            return other.first == p && other.second.dot(normal) > 1.0 - 1e-9;
          });
          if (known) continue;
          seen.emplace_back(p, normal);
          near.push_back({t, r, {face.number, p}, distance_mm - rods[r].radius_mm});
        }
      }
    }
  }
  return near;
}

namespace {

Rule made_rule() {
  Rule rule;
  for (int level = 0; level <= finest; ++level) {
    rule.begin[level] = static_cast<int>(rule.points.size());
    const int parts = 1 << level;
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
      for (const Vector3d& corner : {a, b, c}) rule.points.emplace_back((corner / 2 + (a + b + c) / 6) / parts);
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        const int k = parts - i - j;
        add(Vector3d(i + 1, j, k - 1), Vector3d(i, j + 1, k - 1), Vector3d(i, j, k));
        if (k >= 2) add(Vector3d(i + 1, j, k - 1), Vector3d(i + 1, j + 1, k - 2), Vector3d(i, j + 1, k - 1));
      }
    }
  }
  rule.begin[finest + 1] = static_cast<int>(rule.points.size());
  return rule;
}

const Rule& rule() {
  static const Rule kept = made_rule();
  return kept;
}

int fineness(double edge_mm, double radius_mm, double deepest_between_mm) {
  constexpr double hole_of_edge = 0.29;
  int level = 0;
  for (double hole_mm = hole_of_edge * edge_mm;
       level < finest && hole_mm * hole_mm > 2 * radius_mm * deepest_between_mm; hole_mm /= 2) {
    ++level;
  }
  return level;
}

FaceValues values_at(ElementOrder order, int point) {
  const Vector3d& l = rule().points[static_cast<std::size_t>(point)];
  if (order == ElementOrder::quadratic) return quadratic_triangle_values(l);
  FaceValues values = FaceValues::Zero();
  values.head<3>() = l;
  return values;
}

std::vector<MovedFace> faces_around(const Body& body, const ToolShape& rods, const VectorXd& u_mm, double margin_mm) {
  std::vector<MovedFace> around;
  if (rods.empty()) return around;
  Box all = box_of(rods.front(), margin_mm);
  for (const Rod& rod : rods) {
    const Box box = box_of(rod, margin_mm);
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  }
  const int count = body.layout.order == ElementOrder::quadratic ? 6 : 3;
  for (int f = 0; f < static_cast<int>(body.boundary.size()); ++f) {
    const BoundaryFace& face = body.boundary[static_cast<std::size_t>(f)];
    MovedFace moved{f, Eigen::Matrix<double, 3, 6>::Zero(), Vector3d::Zero(), {}, 0};
    for (int n = 0; n < count; ++n) {
      moved.nodes_mm.col(n) = body.layout.positions_mm[face.nodes[n]] + u_mm.segment<3>(3 * face.nodes[n]);
    }
    moved.box = {moved.nodes_mm.leftCols(count).rowwise().minCoeff(),
                 moved.nodes_mm.leftCols(count).rowwise().maxCoeff()};
    if (!all.meets(moved.box)) continue;
    moved.edge_mm = std::sqrt(4 / std::sqrt(3.0) * face.area_mm2);
    const auto& n = moved.nodes_mm;
    moved.outward = unit_or_zero((n.col(1) - n.col(0)).cross(n.col(2) - n.col(0)));
    around.push_back(moved);
  }
  return around;
}

Box box_of(const Rod& rod, double margin_mm) {
  const double reach_mm = rod.radius_mm + margin_mm;
  return {rod.from_mm.cwiseMin(rod.to_mm).array() - reach_mm, rod.from_mm.cwiseMax(rod.to_mm).array() + reach_mm};
}

// From the nearest place of its axis.
Vector3d arm_of(const Rod& rod, const Vector3d& at_mm) {
  const Vector3d axis = rod.to_mm - rod.from_mm;
  const double along = axis.squaredNorm() > 0 ? (at_mm - rod.from_mm).dot(axis) / axis.squaredNorm() : 0.0;
  return at_mm - rod.from_mm - std::clamp(along, 0.0, 1.0) * axis;
}

}  // namespace
}  // namespace glisson::mechanics
