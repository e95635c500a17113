#include "vasculature/internal/bridges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "vasculature/measured_branch.h"

namespace glisson::vasculature {

using Eigen::Vector3d;

double from_wall_mm(const std::vector<CenterPoint>& line, const Vector3d& place_mm) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const CenterPoint& point : line) {
    nearest_mm = std::min(nearest_mm, (point.position_mm - place_mm).norm() - point.radius_mm);
  }
  return nearest_mm;
}

std::vector<std::vector<int>> VesselGraph::branches_at_vertices() const {
  std::vector<std::vector<int>> at(vertices_mm.size());
  for (std::size_t b = 0; b < branches.size(); ++b) {
    at[static_cast<std::size_t>(branches[b].from)].push_back(static_cast<int>(b));
    if (branches[b].to != branches[b].from) at[static_cast<std::size_t>(branches[b].to)].push_back(static_cast<int>(b));
  }
  return at;
}

void measure(GraphBranch& branch) { measure_by_points(branch); }

void join(VesselGraph& graph, const std::vector<NewJoint>& joints) {
  std::map<int, std::set<int>> cuts;  // points by branch
  for (const NewJoint& joint : joints) {
    cuts[joint.branch_a].insert(joint.point_a);
    cuts[joint.branch_b].insert(joint.point_b);
  }
  std::map<std::pair<int, int>, int> vertex_at;
  for (const auto& [b, points] : cuts) {
    const GraphBranch whole = graph.branches[static_cast<std::size_t>(b)];
    const int last = static_cast<int>(whole.points.size()) - 1;
    int start = 0, start_vertex = whole.from, into = b;
    vertex_at[{b, 0}] = whole.from;
    vertex_at[{b, last}] = whole.to;
    const auto piece = [&](int end, int end_vertex) {
      GraphBranch part{start_vertex, end_vertex, {whole.points.begin() + start, whole.points.begin() + end + 1},
                       whole.joint,  0,          0};
      measure(part);
      if (into >= 0) {
        graph.branches[static_cast<std::size_t>(into)] = std::move(part);
      } else {
        graph.branches.push_back(std::move(part));
      }
      into = -1;
      start = end;
      start_vertex = end_vertex;
    };
    for (const int point : points) {
      if (point <= 0 || point >= last) continue;
      const int vertex = static_cast<int>(graph.vertices_mm.size());
      graph.vertices_mm.push_back(whole.points[static_cast<std::size_t>(point)].position_mm);
      vertex_at[{b, point}] = vertex;
      piece(point, vertex);
    }
    piece(last, whole.to);
  }
  for (const NewJoint& joint : joints) {
    const int from = vertex_at.at({joint.branch_a, joint.point_a}), to = vertex_at.at({joint.branch_b, joint.point_b});
    if (from == to) continue;
    GraphBranch branch{from,
                       to,
                       {{graph.vertices_mm[static_cast<std::size_t>(from)], joint.radius_mm},
                        {graph.vertices_mm[static_cast<std::size_t>(to)], joint.radius_mm}},
                       joint.joint,
                       0,
                       joint.radius_mm};
    measure(branch);
    graph.branches.push_back(std::move(branch));
  }
}

namespace {

// Sets of vertices that hang together.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int v) {
    while (parent_[static_cast<std::size_t>(v)] != v) {
      parent_[static_cast<std::size_t>(v)] = parent_[static_cast<std::size_t>(parent_[static_cast<std::size_t>(v)])];
      v = parent_[static_cast<std::size_t>(v)];
    }
    return v;
  }
  bool unite(int a, int b) {
    a = of(a);
    b = of(b);
    if (a == b) return false;
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    return true;
  }

 private:
  std::vector<int> parent_;
};

// Where a branch ends and nothing goes on: the way in which it points there.
struct LooseEnd {
  int branch = 0, point = 0;
  Vector3d position_mm, outwards;
};

std::vector<LooseEnd> loose_ends(const VesselGraph& graph) {
  const auto at = graph.branches_at_vertices();
  std::vector<LooseEnd> ends;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].size() != 1) continue;
    const int b = at[v].front();
    const GraphBranch& branch = graph.branches[static_cast<std::size_t>(b)];
    const int last = static_cast<int>(branch.points.size()) - 1;
    const bool at_end = branch.to == static_cast<int>(v);
    const CenterPoint& tip = branch.points[static_cast<std::size_t>(at_end ? last : 0)];
    Vector3d inner = tip.position_mm;
    for (int i = 0; i <= last && (inner - tip.position_mm).norm() < std::max(6.0, 2 * tip.radius_mm); ++i) {
      inner = branch.points[static_cast<std::size_t>(at_end ? last - i : i)].position_mm;
    }
    if (inner == tip.position_mm) continue;
    ends.push_back({b, at_end ? last : 0, tip.position_mm, (tip.position_mm - inner).normalized()});
  }
  return ends;
}

// Two ends of vessels as wide as each other that point at each other: one vessel, whatever else joins the two. The
// nearest pairs first.
std::vector<NewJoint> between_facing_ends(const VesselGraph& graph, const std::vector<LooseEnd>& ends,
                                          double maximum_gap_mm) {
  constexpr double cosine_of_facing = 0.87, alike_radii = 0.6;
  std::vector<std::pair<double, NewJoint>> found;
  for (std::size_t a = 0; a < ends.size(); ++a) {
    for (std::size_t b = a + 1; b < ends.size(); ++b) {
      const Vector3d way = ends[b].position_mm - ends[a].position_mm;
      const double length_mm = way.norm();
      if (ends[a].branch == ends[b].branch || length_mm > maximum_gap_mm || length_mm < 1e-6) continue;
      const double straight = std::min(ends[a].outwards.dot(way), -ends[b].outwards.dot(way)) / length_mm;
      const double ra = graph.branches[static_cast<std::size_t>(ends[a].branch)].radius_mm,
                   rb = graph.branches[static_cast<std::size_t>(ends[b].branch)].radius_mm;
      if (straight < cosine_of_facing || std::min(ra, rb) < alike_radii * std::max(ra, rb)) continue;
      found.push_back({(length_mm + 0.5) * (2 - straight),
                       {ends[a].branch, ends[a].point, ends[b].branch, ends[b].point, Joint::gap, std::min(ra, rb)}});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<NewJoint> joints;
  for (const auto& [cost, joint] : found) joints.push_back(joint);
  return joints;
}

}  // namespace

void add_bridges(VesselGraph& graph, double maximum_gap_mm) {
  Pieces pieces(graph.vertices_mm.size());
  for (const GraphBranch& branch : graph.branches) pieces.unite(branch.from, branch.to);
  struct Bridge {
    double cost;
    NewJoint joint;
    int from, to;  // vertices of the two pieces
  };
  std::vector<Bridge> bridges;
  const std::vector<LooseEnd> ends = loose_ends(graph);
  for (const LooseEnd& end : ends) {
    const int own = graph.branches[static_cast<std::size_t>(end.branch)].from;
    std::map<int, Bridge> best;  // by piece
    for (std::size_t b = 0; b < graph.branches.size(); ++b) {
      const GraphBranch& branch = graph.branches[b];
      if (pieces.of(branch.from) == pieces.of(own)) continue;
      for (std::size_t i = 0; i < branch.points.size(); ++i) {
        const CenterPoint& point = branch.points[i];
        const Vector3d way = point.position_mm - end.position_mm;
        const double length = way.norm();
        const bool loose = i == 0 || i + 1 == branch.points.size();
        const double gap = std::max(0.0, length - (loose ? 0 : point.radius_mm));
        if (gap > maximum_gap_mm) continue;
        const double straight = length > 0 ? end.outwards.dot(way) / length : 1;
        if (straight < 0.5 && gap > 2) continue;
        const double cost = (gap + 0.5) * (2 - straight);
        const int piece = pieces.of(branch.from);
        const auto found = best.find(piece);
        if (found != best.end() && found->second.cost <= cost) continue;
        best[piece] = {cost,
                       {end.branch, end.point, static_cast<int>(b), static_cast<int>(i), Joint::gap,
                        std::min(point.radius_mm, graph.branches[static_cast<std::size_t>(end.branch)].radius_mm)},
                       own,
                       branch.from};
      }
    }
    for (auto& [piece, bridge] : best) bridges.push_back(bridge);
  }
  std::stable_sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) { return a.cost < b.cost; });
  std::vector<NewJoint> chosen;
  for (const Bridge& bridge : bridges) {
    if (pieces.unite(bridge.from, bridge.to)) chosen.push_back(bridge.joint);
  }
  for (const NewJoint& joint : between_facing_ends(graph, ends, maximum_gap_mm)) {
    const auto has_an_end_of_it = [&](const NewJoint& other) {
      const auto at = [&](int branch, int point) {
        return (other.branch_a == branch && other.point_a == point) ||
               (other.branch_b == branch && other.point_b == point);
      };
      return at(joint.branch_a, joint.point_a) || at(joint.branch_b, joint.point_b);
    };
    if (std::none_of(chosen.begin(), chosen.end(), has_an_end_of_it)) chosen.push_back(joint);
  }
  join(graph, chosen);
}

}  // namespace glisson::vasculature
