#include "anatomy/internal/capsules.h"

#include <algorithm>
#include <cmath>

namespace glisson::anatomy {

using Eigen::Vector3d;

double distance_mm(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w);
  constexpr double tiny = 1e-12;
  const double determinant = a * c - b * b;
  double s = determinant > tiny ? std::clamp((b * e - c * d) / determinant, 0.0, 1.0) : 0;
  double t = c > tiny ? (b * s + e) / c : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > tiny ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0;
  }
  return (w + s * u - t * v).norm();
}

Capsule capsule_of(const VesselTree& tree, std::size_t node) {
  const VesselNode& end = tree.nodes[node];
  return {tree.nodes[static_cast<std::size_t>(end.parent)].position_mm, end.position_mm, end.radius_mm};
}

namespace {

bool boxes_apart(const Capsule& a, const Capsule& b, double by_mm) {
  const Vector3d low_a = a.from_mm.cwiseMin(a.to_mm), high_a = a.from_mm.cwiseMax(a.to_mm);
  const Vector3d low_b = b.from_mm.cwiseMin(b.to_mm), high_b = b.from_mm.cwiseMax(b.to_mm);
  return ((low_a - high_b).array() > by_mm).any() || ((low_b - high_a).array() > by_mm).any();
}

bool near(const Capsule& a, const Capsule& b, double clear_mm) {
  const double reach = a.radius_mm + b.radius_mm + clear_mm;
  return !boxes_apart(a, b, reach) && distance_mm(a.from_mm, a.to_mm, b.from_mm, b.to_mm) < reach;
}

}  // namespace

bool comes_near(const Capsule& capsule, const VesselTree& tree, double clear_mm) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent >= 0 && near(capsule, capsule_of(tree, i), clear_mm)) return true;
  }
  return false;
}

std::vector<Meeting> meetings(const VesselTree& first, const VesselTree& second, double clear_mm) {
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < first.nodes.size(); ++i) {
    if (first.nodes[i].parent < 0) continue;
    const Capsule capsule = capsule_of(first, i);
    for (std::size_t j = 0; j < second.nodes.size(); ++j) {
      if (second.nodes[j].parent >= 0 && near(capsule, capsule_of(second, j), clear_mm)) found.push_back({i, j});
    }
  }
  return found;
}

double path_mm(const VesselTree& tree, int from, int to) {
  const auto node = [&](int n) -> const VesselNode& { return tree.nodes[static_cast<std::size_t>(n)]; };
  const auto depth = [&](int n) {
    int steps = 0;
    for (; node(n).parent >= 0; n = node(n).parent) ++steps;
    return steps;
  };
  double path = 0;
  const auto climb = [&](int& n) {
    path += (node(n).position_mm - node(node(n).parent).position_mm).norm();
    n = node(n).parent;
  };
  int difference = depth(from) - depth(to);
  for (; difference > 0; --difference) climb(from);
  for (; difference < 0; ++difference) climb(to);
  while (from != to && node(from).parent >= 0) {
    climb(from);
    climb(to);
  }
  return path + (node(from).position_mm - node(to).position_mm).norm();  // entries lie in the same vessel's wall
}

bool trim_parting(Capsule& piece, double other_radius_mm, double path_mm) {
  constexpr double apart = 2.2;  // 1 / sin(30 degrees), and a little
  const double trim = apart * (piece.radius_mm + other_radius_mm) - path_mm;
  if (trim <= 0) return true;
  const Vector3d along = piece.to_mm - piece.from_mm;
  if (trim >= along.norm()) return false;
  piece.from_mm += trim * along.normalized();
  return true;
}

std::vector<Meeting> meetings_within(const VesselTree& tree, double clear_mm) {
  std::vector<Meeting> found;
  const auto parent = [&](std::size_t n) { return tree.nodes[n].parent; };
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (parent(i) < 0) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (parent(j) < 0 || parent(i) == parent(j) || parent(i) == static_cast<int>(j)) continue;
      if (!near(capsule_of(tree, i), capsule_of(tree, j), clear_mm)) continue;
      const auto [finer, wider] = tree.nodes[i].flow <= tree.nodes[j].flow ? std::pair(i, j) : std::pair(j, i);
      Capsule piece = capsule_of(tree, finer);
      const Capsule other = capsule_of(tree, wider);
      const double path =
          std::min(path_mm(tree, parent(finer), static_cast<int>(wider)), path_mm(tree, parent(finer), parent(wider)));
      if (!trim_parting(piece, other.radius_mm, path)) continue;
      if (near(piece, other, clear_mm)) found.push_back({i, j});
    }
  }
  return found;
}

VesselTree pruned(const VesselTree& tree, std::vector<bool> cut) {
  VesselTree kept{tree.system, {}};
  std::vector<int> index(tree.nodes.size(), -1);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const int parent = tree.nodes[i].parent;
    if (parent >= 0 && cut[static_cast<std::size_t>(parent)]) cut[i] = true;
    if (cut[i]) continue;
    index[i] = static_cast<int>(kept.nodes.size());
    kept.nodes.push_back(tree.nodes[i]);
    if (parent >= 0) kept.nodes.back().parent = index[static_cast<std::size_t>(parent)];
  }
  return kept;
}

}  // namespace glisson::anatomy
