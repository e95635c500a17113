#include "vasculature/internal/junctions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "base/upper_median.h"
#include "geometry/disjoint_sets.h"

namespace glisson::vasculature {

namespace {

using Eigen::Vector3d;

// Branches that join vertices to junctions, and the number of each vertex' junction.
struct Links {
  std::vector<char> is_link;
  std::vector<std::vector<int>> at;  // by vertex
  std::vector<int> junction;         // by vertex
};

// A junction of more vertices is noise: what would join them is left out, so that tables of passages stay small.
constexpr std::size_t most_vertices = 64;

Links links_of(const VesselGraph& graph) {
  const auto branches_at = graph.branches_at_vertices();
  Links links{std::vector<char>(graph.branches.size(), 0), std::vector<std::vector<int>>(graph.vertices_mm.size()),
              std::vector<int>(graph.vertices_mm.size())};
  geometry::DisjointSets sets(graph.vertices_mm.size());
  for (std::size_t b = 0; b < graph.branches.size(); ++b) {
    const GraphBranch& branch = graph.branches[b];
    const auto from = static_cast<std::size_t>(branch.from), to = static_cast<std::size_t>(branch.to);
    const bool inner = branches_at[from].size() > 1 && branches_at[to].size() > 1;
    if (branch.joint == Joint::vessel && !(inner && branch.length_mm < branch.radius_mm)) continue;
    links.is_link[b] = 1;
    if (sets.root(from) != sets.root(to) && sets.size_of(from) + sets.size_of(to) > most_vertices) continue;
    sets.join(from, to);
    for (const std::size_t v : {from, to}) links.at[v].push_back(static_cast<int>(b));
  }
  for (std::size_t v = 0; v < links.junction.size(); ++v) links.junction[v] = static_cast<int>(sets.root(v));
  return links;
}

PieceEnd end_of(const GraphBranch& branch, bool last) {
  const std::size_t count = branch.points.size();
  const auto point = [&](std::size_t i) -> const CenterPoint& { return branch.points[last ? count - 1 - i : i]; };
  PieceEnd end;
  end.vertex = last ? branch.to : branch.from;
  end.position_mm = point(0).position_mm;
  const double skip = std::min(point(0).radius_mm, branch.length_mm / 3);
  const double reach = skip + std::max(6.0, 3 * branch.radius_mm);
  std::vector<double> radii;
  Vector3d near = end.position_mm, far = end.position_mm;
  double along = 0;
  for (std::size_t i = 0; i < count && along <= reach; ++i) {
    if (i > 0) along += (point(i).position_mm - point(i - 1).position_mm).norm();
    if (along < skip) {
      near = point(i).position_mm;
      continue;
    }
    radii.push_back(point(i).radius_mm);
    far = point(i).position_mm;
  }
  end.radius_mm = std::max(0.5, radii.empty() ? branch.radius_mm : upper_median(radii));
  if ((near - far).norm() > 0) end.outwards = (near - far).normalized();
  return end;
}

// The shortest ways over links from a vertex to the others of its junction (Dijkstra 1959): the link before each.
std::map<int, int> ways_from(int start, const VesselGraph& graph, const Links& links) {
  constexpr double dearer_than_vessel_mm = 10;
  std::map<int, double> cost = {{start, 0.0}};
  std::map<int, int> before = {{start, -1}};
  using Waiting = std::pair<double, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  queue.emplace(0.0, start);
  while (!queue.empty()) {
    const auto [reached, v] = queue.top();
    queue.pop();
    if (reached > cost.at(v)) continue;
    for (const int l : links.at[static_cast<std::size_t>(v)]) {
      const GraphBranch& link = graph.branches[static_cast<std::size_t>(l)];
      const int next = link.from == v ? link.to : link.from;
      const double offered = reached + link.length_mm + (link.joint == Joint::vessel ? 0 : dearer_than_vessel_mm);
      const auto found = cost.find(next);
      if (found != cost.end() && found->second <= offered) continue;
      cost[next] = offered;
      before[next] = l;
      queue.emplace(offered, next);
    }
  }
  return before;
}

Passage passage_between(const PieceEnd& from, const PieceEnd& to, const std::map<int, int>& before,
                        const VesselGraph& graph) {
  Passage passage;
  const double thinner = std::min(from.radius_mm, to.radius_mm);
  for (int v = to.vertex; v != from.vertex;) {
    const int l = before.at(v);
    const GraphBranch& link = graph.branches[static_cast<std::size_t>(l)];
    passage.branches.push_back(l);
    if (link.joint == Joint::gap) passage.gap_mm += link.length_mm;
    if (link.joint == Joint::contact) {
      passage.contact = true;
      passage.neck = std::min(passage.neck, link.radius_mm / thinner);
    }
    v = link.from == v ? link.to : link.from;
  }
  return passage;
}

}  // namespace

double widening(const GraphBranch& branch, bool backwards) {
  const std::size_t count = branch.points.size();
  double narrowest = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    const std::size_t low = i < 2 ? 0 : i - 2, high = std::min(count - 1, i + 2);
    for (std::size_t n = low; n <= high; ++n) sum += branch.points[backwards ? count - 1 - n : n].radius_mm;
    const double radius = std::log(std::max(0.5, sum / static_cast<double>(high - low + 1)));
    narrowest = std::min(narrowest, radius);
    most = std::max(most, radius - narrowest);
  }
  return most;
}

std::size_t Junctions::between(int end, int other) const {
  const std::size_t count = ends_at[static_cast<std::size_t>(this->end(end).junction)].size();
  return static_cast<std::size_t>(place_of[static_cast<std::size_t>(end)]) * count +
         static_cast<std::size_t>(place_of[static_cast<std::size_t>(other)]);
}

Junctions junctions_of(const VesselGraph& graph) {
  const Links links = links_of(graph);
  Junctions junctions;
  std::map<int, int> numbers;
  for (std::size_t b = 0; b < graph.branches.size(); ++b) {
    if (links.is_link[b] != 0) continue;
    const GraphBranch& branch = graph.branches[b];
    Piece piece{static_cast<int>(b),
                {end_of(branch, false), end_of(branch, true)},
                {widening(branch, false), widening(branch, true)}};
    for (PieceEnd& end : piece.ends) {
      const int first = links.junction[static_cast<std::size_t>(end.vertex)];
      end.junction = numbers.emplace(first, static_cast<int>(numbers.size())).first->second;
      junctions.ends_at.resize(numbers.size());
      std::vector<int>& ends = junctions.ends_at[static_cast<std::size_t>(end.junction)];
      ends.push_back(static_cast<int>(junctions.place_of.size()));
      junctions.place_of.push_back(static_cast<int>(ends.size()) - 1);
    }
    junctions.pieces.push_back(std::move(piece));
  }
  for (const std::vector<int>& ends : junctions.ends_at) {
    std::vector<Passage>& passages = junctions.passages.emplace_back();
    for (const int from : ends) {
      const std::map<int, int> before = ways_from(junctions.end(from).vertex, graph, links);
      for (const int to : ends) {
        passages.push_back(passage_between(junctions.end(from), junctions.end(to), before, graph));
      }
    }
  }
  return junctions;
}

}  // namespace glisson::vasculature
