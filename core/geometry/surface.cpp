#include "geometry/surface.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <Eigen/Geometry>
#include <limits>

#include "geometry/disjoint_sets.h"
#include "geometry/fields.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

// Twice the triangle's area, along its normal.
Vector3d doubled_area_vector(const Surface& surface, const Triangle& triangle) {
  const Vector3d& a = surface.points_mm[static_cast<std::size_t>(triangle[0])];
  const Vector3d& b = surface.points_mm[static_cast<std::size_t>(triangle[1])];
  const Vector3d& c = surface.points_mm[static_cast<std::size_t>(triangle[2])];
  return (b - a).cross(c - a);
}

// The triangles named and the points that they use, in the order of the whole.
Surface part_of(const Surface& whole, const std::vector<int>& triangles) {
  std::vector<int> renumbered(whole.points_mm.size(), -1);
  for (const int triangle : triangles) {
    for (const int point : whole.triangles[static_cast<std::size_t>(triangle)]) {
      renumbered[static_cast<std::size_t>(point)] = 0;
    }
  }
  Surface part;
  std::vector<int> points;
  for (std::size_t point = 0; point < renumbered.size(); ++point) {
    if (renumbered[point] < 0) continue;
    renumbered[point] = static_cast<int>(points.size());
    points.push_back(static_cast<int>(point));
    part.points_mm.push_back(whole.points_mm[point]);
  }
  for (const int triangle : triangles) {
    Triangle corners = whole.triangles[static_cast<std::size_t>(triangle)];
    for (int& corner : corners) corner = renumbered[static_cast<std::size_t>(corner)];
    part.triangles.push_back(corners);
  }
  part.point_fields = select(whole.point_fields, points);
  part.cell_fields = select(whole.cell_fields, triangles);
  return part;
}

}  // namespace

Box bounding_box(const std::vector<Vector3d>& points_mm) {
  if (points_mm.empty()) return {};
  Box box{points_mm.front(), points_mm.front()};
  for (const Vector3d& point : points_mm) {
    box.min_mm = box.min_mm.cwiseMin(point);
    box.max_mm = box.max_mm.cwiseMax(point);
  }
  return box;
}

double area_mm2(const Surface& surface) {
  double doubled = 0;
  for (const Triangle& triangle : surface.triangles) doubled += doubled_area_vector(surface, triangle).norm();
  return 0.5 * doubled;
}

double volume_mm3(const Surface& surface) {
  // Seen from the middle of the box rather than the origin, which may be metres away and would cost digits.
  const Vector3d middle = bounding_box(surface.points_mm).center_mm();
  double sixfold = 0;
  for (const Triangle& triangle : surface.triangles) {
    const Vector3d& corner = surface.points_mm[static_cast<std::size_t>(triangle[0])];
    sixfold += (corner - middle).dot(doubled_area_vector(surface, triangle));
  }
  return sixfold / 6.0;
}

bool is_watertight(const Surface& surface) {
  using Edge = std::pair<int, int>;
  std::vector<Edge> edges;
  std::vector<Edge> reversed;
  edges.reserve(3 * surface.triangles.size());
  reversed.reserve(3 * surface.triangles.size());
  for (const Triangle& triangle : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
      reversed.emplace_back(triangle[(i + 1) % 3], triangle[i]);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  const bool each_once = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  return !edges.empty() && each_once && edges == reversed;
}

std::vector<int> pinched_points(const Surface& surface) {
  // A triangle (p, a, b) leads around p from a to b. One closed fan: every step has one that follows it, and following
  // the steps from any of them comes back after all of them.
  struct Step {
    int point, from, to;
    auto operator<=>(const Step&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 reads 0 as a pointer
  };
  std::vector<Step> steps;
  steps.reserve(3 * surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) steps.insert(steps.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
  std::sort(steps.begin(), steps.end());

  std::vector<int> pinched;
  for (std::size_t begin = 0, end = 0; begin < steps.size(); begin = end) {
    while (end < steps.size() && steps[end].point == steps[begin].point) ++end;
    const auto first = steps.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = steps.begin() + static_cast<std::ptrdiff_t>(end);
    std::size_t walked = 0;
    int at = first->from;
    do {
      const auto step = std::lower_bound(first, last, Step{first->point, at, std::numeric_limits<int>::min()});
      if (step == last || step->from != at) break;
      at = step->to;
      ++walked;
    } while (at != first->from && walked <= end - begin);
    if (at != first->from || walked != end - begin) pinched.push_back(first->point);
  }
  return pinched;
}

std::vector<Vector3d> point_normals(const Surface& surface) {
  std::vector<Vector3d> normals(surface.points_mm.size(), Vector3d::Zero());
  for (const Triangle& triangle : surface.triangles) {
    const Vector3d weighted = doubled_area_vector(surface, triangle);
    for (const int corner : triangle) normals[static_cast<std::size_t>(corner)] += weighted;
  }
  for (Vector3d& normal : normals) normal.stableNormalize();
  return normals;
}

std::vector<Surface> connected_pieces(const Surface& surface) {
  DisjointSets sets(surface.points_mm.size());
  for (const Triangle& triangle : surface.triangles) {
    sets.join(static_cast<std::size_t>(triangle[0]), static_cast<std::size_t>(triangle[1]));
    sets.join(static_cast<std::size_t>(triangle[0]), static_cast<std::size_t>(triangle[2]));
  }
  std::vector<int> piece_of_root(surface.points_mm.size(), -1);
  std::vector<std::vector<int>> triangles_of_piece;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    int& piece = piece_of_root[sets.root(static_cast<std::size_t>(surface.triangles[i][0]))];
    if (piece < 0) {
      piece = static_cast<int>(triangles_of_piece.size());
      triangles_of_piece.emplace_back();
    }
    triangles_of_piece[static_cast<std::size_t>(piece)].push_back(static_cast<int>(i));
  }

  std::vector<std::pair<double, Surface>> by_area;
  for (const std::vector<int>& triangles : triangles_of_piece) {
    Surface piece = part_of(surface, triangles);
    const double area = area_mm2(piece);
    by_area.emplace_back(area, std::move(piece));
  }
  std::stable_sort(by_area.begin(), by_area.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Surface> pieces;
  for (auto& [area, piece] : by_area) pieces.push_back(std::move(piece));
  return pieces;
}

namespace {

// More than rounding could make of three points on a line.
bool has_area_of_its_own(const Surface& surface, const std::array<int, 3>& triangle) {
  const auto corner = [&](std::size_t k) { return surface.points_mm[static_cast<std::size_t>(triangle[k])]; };
  const double longest_mm2 = std::max((corner(1) - corner(0)).squaredNorm(), (corner(2) - corner(0)).squaredNorm());
  return doubled_area_vector(surface, triangle).norm() > 1e-12 * longest_mm2;
}

}  // namespace

Result<void> check_surface(const Surface& surface) {
  for (std::size_t i = 0; i < surface.points_mm.size(); ++i) {
    if (!surface.points_mm[i].allFinite()) {
      return failure("surface-not-finite", GLISSON_TEXT("Point {0} of the surface has no finite position."),
                     {std::to_string(i)});
    }
    constexpr double farthest_mm = 1e9;  // a thousand kilometres
    if (surface.points_mm[i].cwiseAbs().maxCoeff() > farthest_mm) {
      return failure("surface-too-far",
                     GLISSON_TEXT("Point {0} of the surface lies farther off than a thousand kilometres."),
                     {std::to_string(i)});
    }
  }
  const auto points = static_cast<std::int64_t>(surface.points_mm.size());
  bool has_area = false;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    for (const int corner : surface.triangles[i]) {
      if (corner < 0 || corner >= points) {
        return failure("surface-index", GLISSON_TEXT("Triangle {0} names point {1}; the surface has {2} points."),
                       {std::to_string(i), std::to_string(corner), std::to_string(points)});
      }
    }
    has_area = has_area || has_area_of_its_own(surface, surface.triangles[i]);
  }
  if (surface.triangles.empty()) {
    return failure("surface-empty", GLISSON_TEXT("The surface holds no triangles."));
  }
  if (!has_area) {
    return failure("surface-flat", GLISSON_TEXT("No triangle of the surface has an area: they are lines or points."));
  }
  return {};
}

Eigen::Vector3d mean_point_mm(const Surface& surface) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : surface.points_mm) sum += point;
  return sum / static_cast<double>(surface.points_mm.size());
}

}  // namespace glisson::geometry
