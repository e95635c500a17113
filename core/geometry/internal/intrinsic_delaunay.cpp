#include "geometry/internal/intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace glisson::geometry {
namespace {

// Half-edge 3 t + k runs from corner k of triangle t to its corner k + 1.
struct HalfEdges {
  std::vector<int> from;  // a point
  std::vector<int> twin;  // -1 on the border
  std::vector<double> length_mm;

  explicit HalfEdges(const Surface& surface);

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] int to(int h) const { return from[next(h)]; }

  // Of the angle across from it.
  [[nodiscard]] double cotangent(int h) const;
  [[nodiscard]] bool is_delaunay(int h) const;
  // In the two triangles beside it the other diagonal takes its place.
  void flip(int h);
};

}  // namespace

std::vector<IntrinsicTriangle> intrinsic_delaunay(const Surface& surface) {
  HalfEdges edges(surface);
  const auto count = static_cast<int>(edges.from.size());
  std::vector<int> waiting(edges.from.size());
  for (int h = 0; h < count; ++h) waiting[static_cast<std::size_t>(h)] = count - 1 - h;
  // Each flip lowers the Dirichlet energy, so that there are finitely many. Rounding could undo that.
  for (std::int64_t flips = 0; !waiting.empty() && flips < std::int64_t{100} * count;) {
    const int h = waiting.back();
    waiting.pop_back();
    if (edges.is_delaunay(h)) continue;
    const int other = edges.twin[h];
    edges.flip(h);
    ++flips;
    for (const int around : {HalfEdges::next(h), HalfEdges::next(HalfEdges::next(h)), HalfEdges::next(other),
                             HalfEdges::next(HalfEdges::next(other))}) {
      waiting.push_back(around);
    }
  }
  std::vector<IntrinsicTriangle> triangles(surface.triangles.size());
  for (int h = 0; h < count; ++h) {
    triangles[h / 3].points[h % 3] = edges.from[h];
    triangles[h / 3].lengths_mm[h % 3] = edges.length_mm[h];
  }
  return triangles;
}

Eigen::Vector2d third_corner_mm(double length_mm, double from_second_mm, double to_first_mm) {
  const double along_mm = (length_mm * length_mm + to_first_mm * to_first_mm - from_second_mm * from_second_mm) /
                          (2 * std::max(length_mm, 1e-300));
  return {along_mm, std::sqrt(std::max(to_first_mm * to_first_mm - along_mm * along_mm, 0.0))};
}

namespace {

HalfEdges::HalfEdges(const Surface& surface)
    : from(3 * surface.triangles.size()), twin(from.size(), -1), length_mm(from.size()) {
  std::unordered_map<std::uint64_t, int> seen;
  seen.reserve(from.size());
  const auto key = [](int a, int b) { return (std::uint64_t(std::uint32_t(a)) << 32) | std::uint32_t(b); };
  for (std::size_t h = 0; h < from.size(); ++h) {
    const auto& corners = surface.triangles[h / 3];
    const int a = corners[h % 3], b = corners[(h + 1) % 3];
    from[h] = a;
    length_mm[h] =
        (surface.points_mm[static_cast<std::size_t>(b)] - surface.points_mm[static_cast<std::size_t>(a)]).norm();
    seen.emplace(key(a, b), static_cast<int>(h));
    if (const auto other = seen.find(key(b, a)); other != seen.end()) {
      twin[h] = other->second;
      twin[static_cast<std::size_t>(other->second)] = static_cast<int>(h);
    }
  }
}

// By Heron's formula in Kahan's order, which holds for thin triangles. A flat triangle's are as large as can be.
double HalfEdges::cotangent(int h) const {
  const double across = length_mm[h], b = length_mm[next(h)], c = length_mm[next(next(h))];
  std::array<double, 3> sorted{across, b, c};
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const auto [x, y, z] = sorted;
  const double product = (x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z));
  const double four_areas = std::sqrt(std::max(product, 0.0));
  return (b * b + c * c - across * across) / std::max(four_areas, 1e-12 * x * x);
}

bool HalfEdges::is_delaunay(int h) const {
  constexpr double rounding = 1e-9;
  const int other = twin[h];
  if (other < 0 || other / 3 == h / 3) return true;
  return cotangent(h) + cotangent(other) >= -rounding;
}

void HalfEdges::flip(int h) {
  // i -> j between the triangles i j k and j i l becomes l -> k, in i l k and j k l.
  const int g = twin[h];
  const std::array<int, 2> first{next(h), next(next(h))};   // j -> k, k -> i
  const std::array<int, 2> second{next(g), next(next(g))};  // i -> l, l -> j
  const Eigen::Vector2d k_mm = third_corner_mm(length_mm[h], length_mm[first[0]], length_mm[first[1]]);
  Eigen::Vector2d l_mm = third_corner_mm(length_mm[h], length_mm[second[1]], length_mm[second[0]]);
  l_mm.y() = -l_mm.y();
  const double diagonal_mm = (k_mm - l_mm).norm();

  struct Outer {
    int old, now, from, twin;
    double length_mm;
  };
  const int t = h - h % 3, s = g - g % 3;  // i l k and j k l
  const auto outer = [&](int old, int now) { return Outer{old, now, from[old], twin[old], length_mm[old]}; };
  const std::array<Outer, 4> around{outer(second[0], t), outer(first[1], t + 2), outer(first[0], s),
                                    outer(second[1], s + 2)};
  const int k = from[first[1]], l = from[second[1]];
  for (const Outer& edge : around) {
    from[edge.now] = edge.from;
    length_mm[edge.now] = edge.length_mm;
  }
  for (const Outer& edge : around) {
    int other = edge.twin;
    for (const Outer& moved : around) {
      if (edge.twin == moved.old) other = moved.now;
    }
    twin[edge.now] = other;
    if (other >= 0) twin[other] = edge.now;
  }
  from[t + 1] = l;
  from[s + 1] = k;
  twin[t + 1] = s + 1;
  twin[s + 1] = t + 1;
  length_mm[t + 1] = length_mm[s + 1] = diagonal_mm;
}

}  // namespace
}  // namespace glisson::geometry
