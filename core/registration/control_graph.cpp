#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <set>

#include "registration/internal/control_graph.h"

namespace glisson::registration {
namespace {

using geometry::Surface;
using Neighbours = std::vector<std::vector<int>>;

Neighbours neighbours_of(const Surface& surface) {
  Neighbours neighbours(surface.points_mm.size());
  const auto join = [&](int a, int b) {
    neighbours[static_cast<std::size_t>(a)].push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
  };
  for (const auto& [a, b, c] : surface.triangles) {
    join(a, b);
    join(b, c);
    join(c, a);
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

// Farthest points through space, which spreads them well enough over a surface.
std::vector<int> spread_points(const Surface& surface, int count) {
  std::vector<double> squared_mm2(surface.points_mm.size(), std::numeric_limits<double>::infinity());
  std::vector<int> chosen;
  int next = 0;
  while (static_cast<int>(chosen.size()) < count) {
    chosen.push_back(next);
    const Eigen::Vector3d& latest = surface.points_mm[static_cast<std::size_t>(next)];
    for (std::size_t i = 0; i < squared_mm2.size(); ++i) {
      squared_mm2[i] = std::min(squared_mm2[i], (surface.points_mm[i] - latest).squaredNorm());
    }
    next = static_cast<int>(std::max_element(squared_mm2.begin(), squared_mm2.end()) - squared_mm2.begin());
  }
  return chosen;
}

// Which control is nearest to each point along the edges (Dijkstra from all of them at once); -1 in a piece without.
std::vector<int> cells_of(const Surface& surface, const Neighbours& neighbours, const std::vector<int>& controls) {
  std::vector<double> distance_mm(surface.points_mm.size(), std::numeric_limits<double>::infinity());
  std::vector<int> cell(surface.points_mm.size(), -1);
  using Visit = std::pair<double, int>;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<>> queue;
  for (std::size_t control = 0; control < controls.size(); ++control) {
    const auto point = static_cast<std::size_t>(controls[control]);
    distance_mm[point] = 0;
    cell[point] = static_cast<int>(control);
    queue.emplace(0.0, controls[control]);
  }
  while (!queue.empty()) {
    const auto [so_far_mm, point] = queue.top();
    queue.pop();
    if (so_far_mm > distance_mm[static_cast<std::size_t>(point)]) continue;
    for (const int neighbour : neighbours[static_cast<std::size_t>(point)]) {
      const auto to = static_cast<std::size_t>(neighbour);
      const double through_mm =
          so_far_mm + (surface.points_mm[to] - surface.points_mm[static_cast<std::size_t>(point)]).norm();
      if (through_mm >= distance_mm[to]) continue;
      distance_mm[to] = through_mm;
      cell[to] = cell[static_cast<std::size_t>(point)];
      queue.emplace(through_mm, neighbour);
    }
  }
  return cell;
}

}  // namespace

ControlGraph control_graph(const Surface& surface, int maximum) {
  const Neighbours neighbours = neighbours_of(surface);
  const std::size_t points = surface.points_mm.size();
  ControlGraph graph;
  const bool all = points <= static_cast<std::size_t>(maximum);
  if (all) {
    graph.points.resize(points);
    std::iota(graph.points.begin(), graph.points.end(), 0);
  } else {
    graph.points = spread_points(surface, maximum);
  }
  const std::vector<int> cell = cells_of(surface, neighbours, graph.points);

  std::set<std::pair<int, int>> edges;
  for (std::size_t point = 0; point < points; ++point) {
    for (const int neighbour : neighbours[point]) {
      const int other = cell[static_cast<std::size_t>(neighbour)];
      if (cell[point] >= 0 && other > cell[point]) edges.insert({cell[point], other});
    }
  }
  graph.edges.assign(edges.begin(), edges.end());

  // Each point follows its own control and those around that, by (1 - d / farthest)^2, as Sumner et al. weigh them.
  std::vector<std::vector<int>> around(graph.points.size());
  for (const auto& [a, b] : graph.edges) {
    around[static_cast<std::size_t>(a)].push_back(b);
    around[static_cast<std::size_t>(b)].push_back(a);
  }
  graph.shares.resize(points);
  for (std::size_t point = 0; point < points; ++point) {
    const int own = std::max(cell[point], 0);
    auto& shares = graph.shares[point];
    shares.push_back({own, 1});
    if (all || cell[point] < 0) continue;
    const auto distance_mm = [&](int control) {
      const auto at = static_cast<std::size_t>(graph.points[static_cast<std::size_t>(control)]);
      return (surface.points_mm[at] - surface.points_mm[point]).norm();
    };
    double farthest_mm = 0;
    for (const int control : around[static_cast<std::size_t>(own)]) {
      farthest_mm = std::max(farthest_mm, distance_mm(control));
    }
    if (farthest_mm <= 0) continue;
    const auto weigh = [&](int control) {
      const double rest = std::max(0.0, 1 - distance_mm(control) / farthest_mm);
      return rest * rest;
    };
    shares.front().weight = weigh(own);
    for (const int control : around[static_cast<std::size_t>(own)]) shares.push_back({control, weigh(control)});
    std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.weight > b.weight; });
    if (shares.size() > 4) shares.resize(4);
    double total = 0;
    for (const auto& share : shares) total += share.weight;
    if (total <= 0) shares = {{own, 1}};
    for (auto& share : shares) share.weight /= total > 0 ? total : 1;
  }
  return graph;
}

}  // namespace glisson::registration
