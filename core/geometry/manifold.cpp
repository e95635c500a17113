#include "geometry/manifold.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <map>

#include "geometry/disjoint_sets.h"

namespace glisson::geometry {
namespace {

using Triangle = std::array<int, 3>;

// The corners of all triangles, three each. An edge is found from the two points it runs between; neighbours that are
// turned alike run along it in opposite directions.
class FaceCorners {
 public:
  explicit FaceCorners(const std::vector<Triangle>& triangles) : triangles_(triangles) {
    for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
      edge_from_.try_emplace({point(corner), point(next(corner))}, corner);
    }
  }

  static std::size_t next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  [[nodiscard]] int point(std::size_t corner) const { return triangles_[corner / 3][corner % 3]; }

  // Calls with the corner at which an edge begins, and the one at which its neighbour's begins.
  template <typename Visit>
  void each_shared_edge(const Visit& visit) const {
    for (const auto& [edge, corner] : edge_from_) {
      if (edge.first > edge.second) continue;
      const auto back = edge_from_.find({edge.second, edge.first});
      if (back != edge_from_.end()) visit(corner, back->second);
    }
  }

 private:
  const std::vector<Triangle>& triangles_;
  std::map<std::pair<int, int>, std::size_t> edge_from_;
};

std::vector<Triangle> without_third_triangles(const std::vector<Triangle>& triangles);
std::vector<Triangle> largest_by_shared_edges(const std::vector<Triangle>& triangles, const Surface& surface);

}  // namespace

Surface largest_manifold_piece(const Surface& surface) {
  std::vector<Triangle> triangles = largest_by_shared_edges(without_third_triangles(surface.triangles), surface);
  const FaceCorners corners(triangles);
  DisjointSets fans(3 * triangles.size());
  corners.each_shared_edge([&](std::size_t a, std::size_t b) {
    fans.join(a, FaceCorners::next(b));
    fans.join(FaceCorners::next(a), b);
  });
  // One point a fan, in the order of the points they come from.
  std::vector<std::pair<int, std::size_t>> wanted;
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    if (fans.root(corner) == corner) wanted.emplace_back(corners.point(corner), corner);
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<int> point_of_fan(3 * triangles.size(), -1);
  Surface piece;
  for (const Field& field : surface.point_fields) piece.point_fields.push_back({field.name, field.components, {}});
  for (const auto& [point, fan] : wanted) {
    const auto from = static_cast<std::size_t>(point);
    point_of_fan[fan] = static_cast<int>(piece.points_mm.size());
    piece.points_mm.push_back(surface.points_mm[from]);
    for (std::size_t f = 0; f < surface.point_fields.size(); ++f) {
      const auto components = static_cast<std::size_t>(surface.point_fields[f].components);
      const auto first = surface.point_fields[f].values.begin() + static_cast<std::ptrdiff_t>(components * from);
      piece.point_fields[f].values.insert(piece.point_fields[f].values.end(), first,
                                          first + static_cast<std::ptrdiff_t>(components));
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    piece.triangles.push_back(
        {point_of_fan[fans.root(3 * i)], point_of_fan[fans.root(3 * i + 1)], point_of_fan[fans.root(3 * i + 2)]});
  }
  return piece;
}

namespace {

std::vector<Triangle> without_third_triangles(const std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, bool> taken;
  std::vector<Triangle> kept;
  for (const auto& [a, b, c] : triangles) {
    if (a == b || b == c || c == a) continue;
    if (taken.count({a, b}) + taken.count({b, c}) + taken.count({c, a}) > 0) continue;
    taken[{a, b}] = taken[{b, c}] = taken[{c, a}] = true;
    kept.push_back({a, b, c});
  }
  return kept;
}

std::vector<Triangle> largest_by_shared_edges(const std::vector<Triangle>& triangles, const Surface& surface) {
  DisjointSets sets(triangles.size());
  FaceCorners(triangles).each_shared_edge([&](std::size_t a, std::size_t b) { sets.join(a / 3, b / 3); });
  const auto at = [&](int point) { return surface.points_mm[static_cast<std::size_t>(point)]; };
  std::vector<double> area(triangles.size(), 0);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    area[sets.root(i)] += 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
  }
  const auto largest = static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (sets.root(i) == largest) kept.push_back(triangles[i]);
  }
  return kept;
}

}  // namespace
}  // namespace glisson::geometry
