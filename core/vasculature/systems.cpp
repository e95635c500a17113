#include "vasculature/systems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "vasculature/internal/junctions.h"
#include "vasculature/internal/nearest_voxel.h"
#include "vasculature/internal/told_apart.h"

namespace glisson::vasculature {

using Eigen::Vector3d;

namespace {

// What it costs: chosen, and looked at on generated patients 1 to 3.
constexpr double of_turn = 1.0, of_widening = 2.0, of_contact = 0.5, of_gap_per_mm = 0.05, of_length_per_mm = 0.005,
                 of_entry_distance_per_mm = 0.05, of_entry_thinness = 1.0;
// Forks nearer than this share of the radius count as one: chosen on generated patients 1 to 10.
constexpr double near_forks = 0.4;

// A branch in one of its two directions.
struct Way {
  const VesselGraph* graph;
  int branch;
  bool backwards;

  [[nodiscard]] const GraphBranch& of() const { return graph->branches[static_cast<std::size_t>(branch)]; }
  [[nodiscard]] int head() const { return backwards ? of().from : of().to; }
  [[nodiscard]] int tail() const { return backwards ? of().to : of().from; }
  [[nodiscard]] const CenterPoint& point(std::size_t i) const {
    return of().points[backwards ? of().points.size() - 1 - i : i];
  }
  [[nodiscard]] Vector3d direction(bool at_head) const;
};

// One system grows along a graph from where it enters.
class Growth {
 public:
  Growth(const VesselGraph& graph, const Vector3d& entry_mm);

  // Each branch by the way in which it is reached at least cost.
  struct Claim {
    int way = -1, before = -1;  // ways
  };
  [[nodiscard]] std::vector<Claim> claims(std::optional<int> from_vertex = {}) const;  // none: from anywhere

 private:
  [[nodiscard]] Way way(int w) const { return {&graph_, w / 2, w % 2 == 1}; }
  [[nodiscard]] double start_cost(int w) const;
  [[nodiscard]] double turn_cost(int from, int to) const;

  const VesselGraph& graph_;
  Vector3d entry_mm_;
  std::vector<int> cluster_;               // of each vertex: those joined by stretches shorter than they are wide
  std::vector<std::vector<int>> leaving_;  // ways that leave each cluster
  std::vector<double> own_;
  double widest_ = 0;  // radius near the entry
};

Vector3d Way::direction(bool at_head) const {
  const std::size_t count = of().points.size();
  const Vector3d end = point(at_head ? count - 1 : 0).position_mm;
  const double reach = std::max(6.0, 2.5 * of().radius_mm);
  Vector3d inner = end;
  for (std::size_t i = 1; i < count && (inner - end).norm() < reach; ++i) {
    inner = point(at_head ? count - 1 - i : i).position_mm;
  }
  const Vector3d along = at_head ? Vector3d(end - inner) : Vector3d(inner - end);
  return along.norm() > 0 ? along.normalized() : Vector3d::Zero();
}

Growth::Growth(const VesselGraph& graph, const Vector3d& entry_mm)
    : graph_(graph), entry_mm_(entry_mm), cluster_(graph.vertices_mm.size()) {
  for (std::size_t v = 0; v < cluster_.size(); ++v) cluster_[v] = static_cast<int>(v);
  const auto root = [&](int v) {
    while (cluster_[static_cast<std::size_t>(v)] != v) v = cluster_[static_cast<std::size_t>(v)];
    return v;
  };
  const auto at = graph.branches_at_vertices();
  for (const GraphBranch& branch : graph.branches) {
    const bool inner =
        at[static_cast<std::size_t>(branch.from)].size() > 1 && at[static_cast<std::size_t>(branch.to)].size() > 1;
    const int a = root(branch.from), b = root(branch.to);
    if (inner && branch.joint == Joint::vessel && branch.length_mm < near_forks * branch.radius_mm) {
      cluster_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  for (std::size_t v = 0; v < cluster_.size(); ++v) cluster_[v] = root(static_cast<int>(v));
  leaving_.resize(cluster_.size());
  for (int w = 0; w < 2 * static_cast<int>(graph.branches.size()); ++w) {
    leaving_[static_cast<std::size_t>(cluster_[static_cast<std::size_t>(way(w).tail())])].push_back(w);
    const GraphBranch& branch = way(w).of();
    double cost = of_length_per_mm * branch.length_mm;
    if (branch.joint == Joint::contact) cost += of_contact;
    if (branch.joint == Joint::gap) cost += of_gap_per_mm * branch.length_mm;
    own_.push_back(cost + of_widening * widening(way(w).of(), way(w).backwards));
  }
  for (const GraphBranch& branch : graph.branches) {
    for (const CenterPoint& point : branch.points) {
      if ((point.position_mm - entry_mm_).norm() < 30) widest_ = std::max(widest_, point.radius_mm);
    }
  }
}

double Growth::start_cost(int w) const {
  const Way start = way(w);
  const double away = (start.point(0).position_mm - entry_mm_).norm();
  const double thin = std::log(std::max(1.0, std::max(widest_, 3.0) / std::max(0.5, start.of().radius_mm)));
  return of_entry_distance_per_mm * away + of_entry_thinness * thin + own_[static_cast<std::size_t>(w)];
}

double Growth::turn_cost(int from, int to) const {
  const Way a = way(from), b = way(to);
  const double straight = a.direction(true).dot(b.direction(false));
  const double wider = std::log(std::max(0.5, b.of().radius_mm) / std::max(0.5, a.of().radius_mm));
  return of_turn * (1 - straight) * (1 - straight) + of_widening * std::max(0.0, wider);
}

std::vector<Growth::Claim> Growth::claims(std::optional<int> from_vertex) const {
  struct Waiting {
    double cost;
    int way, before;
    bool operator>(const Waiting& other) const { return std::tie(cost, way) > std::tie(other.cost, other.way); }
  };
  std::vector<Claim> claims(own_.size() / 2);
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  for (int w = 0; w < static_cast<int>(own_.size()); ++w) {
    if (!from_vertex || way(w).tail() == *from_vertex) queue.push({start_cost(w), w, -1});
  }
  while (!queue.empty()) {
    const Waiting first = queue.top();
    queue.pop();
    Claim& claim = claims[static_cast<std::size_t>(first.way / 2)];
    if (claim.way >= 0) continue;
    claim = {first.way, first.before};
    for (const int next :
         leaving_[static_cast<std::size_t>(cluster_[static_cast<std::size_t>(way(first.way).head())])]) {
      if (next / 2 == first.way / 2 || claims[static_cast<std::size_t>(next / 2)].way >= 0) continue;
      queue.push({first.cost + turn_cost(first.way, next) + own_[static_cast<std::size_t>(next)], next, first.way});
    }
  }
  return claims;
}

// Thick places near where one is expected, the best first.
std::vector<Vector3d> thick_places(const VesselGraph& graph, const Vector3d& expected_mm, double spread_mm, int count) {
  std::vector<std::pair<double, Vector3d>> scored;
  for (const GraphBranch& branch : graph.branches) {
    for (const CenterPoint& point : branch.points) {
      const double away = (point.position_mm - expected_mm).norm() / spread_mm;
      scored.emplace_back(2 * std::log(std::max(0.5, point.radius_mm)) - 0.5 * away * away, point.position_mm);
    }
  }
  std::stable_sort(scored.begin(), scored.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Vector3d> places;
  for (const auto& [score, place] : scored) {
    if (static_cast<int>(places.size()) == count) break;
    const auto near = [&, here = place](const Vector3d& other) { return (other - here).norm() < spread_mm; };
    if (std::none_of(places.begin(), places.end(), near)) places.push_back(place);
  }
  if (places.empty()) places.push_back(expected_mm);
  return places;
}

std::vector<double> sure(const VesselGraph& graph) { return std::vector<double>(graph.branches.size(), 1.0); }

// Those that hang together, in the order of their first branches.
std::vector<VesselGraph> pieces_of(const VesselGraph& graph) {
  geometry::DisjointSets joined(graph.vertices_mm.size());
  for (const GraphBranch& branch : graph.branches) {
    joined.join(static_cast<std::size_t>(branch.from), static_cast<std::size_t>(branch.to));
  }
  std::vector<VesselGraph> pieces;
  std::vector<int> piece_of(graph.vertices_mm.size(), -1);
  for (const GraphBranch& branch : graph.branches) {
    int& piece = piece_of[joined.root(static_cast<std::size_t>(branch.from))];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.push_back({graph.vertices_mm, {}});
    }
    pieces[static_cast<std::size_t>(piece)].branches.push_back(branch);
  }
  return pieces;
}

// To within a few millimetres.
double distance_mm(const Vector3d& place_mm, const imaging::Mask& liver) {
  constexpr double apart_mm = 3;
  const imaging::Grid& grid = liver.grid;
  std::array<int, 3> step{};
  for (std::size_t a = 0; a < 3; ++a) {
    step[a] = std::max(1, static_cast<int>(std::lround(apart_mm / grid.spacing_mm[static_cast<Eigen::Index>(a)])));
  }
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (int k = 0; k < grid.size[2]; k += step[2]) {
    for (int j = 0; j < grid.size[1]; j += step[1]) {
      for (int i = 0; i < grid.size[0]; i += step[0]) {
        if (liver.at(i, j, k) == 0) continue;
        nearest_mm = std::min(nearest_mm, (grid.position_mm(i, j, k) - place_mm).norm());
      }
    }
  }
  return nearest_mm;
}

// Where blood or bile comes in or goes: the vertex of an end outside of the liver.
std::optional<int> open_end(const VesselGraph& graph, const imaging::Mask& liver) {
  const auto at = graph.branches_at_vertices();
  std::optional<int> end;
  double best = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto voxel = nearest_voxel(liver.grid, graph.vertices_mm[v]);
    if (at[v].size() != 1 || (voxel && liver.values[*voxel] != 0)) continue;
    const double radius_mm = graph.branches[static_cast<std::size_t>(at[v].front())].radius_mm;
    const double width_and_distance = radius_mm * distance_mm(graph.vertices_mm[v], liver);
    if (width_and_distance <= best) continue;
    best = width_and_distance;
    end = static_cast<int>(v);
  }
  return end;
}

// Trees of all branches of a graph, parents first. Contacts and bridges that lead nowhere are left out.
void add_trees(const VesselGraph& graph, System system, const std::vector<Growth::Claim>& claims,
               const std::vector<double>& confidence, VesselTrees& trees) {
  std::vector<std::vector<int>> children(claims.size());
  std::vector<int> roots;
  for (std::size_t b = 0; b < claims.size(); ++b) {
    if (claims[b].before < 0) {
      roots.push_back(static_cast<int>(b));
    } else {
      children[static_cast<std::size_t>(claims[b].before / 2)].push_back(static_cast<int>(b));
    }
  }
  // Deepest first, so that what leads nowhere goes with all that leads there alone.
  std::vector<int> order = roots;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& next = children[static_cast<std::size_t>(order[i])];
    order.insert(order.end(), next.begin(), next.end());
  }
  std::vector<char> kept(claims.size(), 0);
  for (auto b = order.rbegin(); b != order.rend(); ++b) {
    const auto& next = children[static_cast<std::size_t>(*b)];
    kept[static_cast<std::size_t>(*b)] =
        graph.branches[static_cast<std::size_t>(*b)].joint == Joint::vessel ||
                std::any_of(next.begin(), next.end(), [&](int c) { return kept[static_cast<std::size_t>(c)] != 0; })
            ? 1
            : 0;
  }
  std::vector<int> index(claims.size(), -1);
  for (const int b : order) {
    const auto i = static_cast<std::size_t>(b);
    if (kept[i] == 0) continue;
    index[i] = static_cast<int>(trees.branches.size());
    const GraphBranch& from = graph.branches[i];
    TreeBranch branch;
    branch.system = system;
    branch.confidence = confidence[i];
    branch.parent = claims[i].before < 0 ? -1 : index[static_cast<std::size_t>(claims[i].before / 2)];
    if (branch.parent >= 0) {
      const std::size_t siblings = children[static_cast<std::size_t>(claims[i].before / 2)].size();
      branch.generation = trees.branches[static_cast<std::size_t>(branch.parent)].generation + (siblings > 1 ? 1 : 0);
    }
    branch.points = from.points;
    if (claims[i].way % 2 == 1) std::reverse(branch.points.begin(), branch.points.end());
    branch.joint = from.joint;
    branch.length_mm = from.length_mm;
    branch.radius_mm = from.radius_mm;
    trees.branches.push_back(std::move(branch));
  }
}

}  // namespace

const char* system_name(System system) {
  static constexpr std::array<const char*, all_systems.size()> names = {"portal-vein", "hepatic-vein", "artery",
                                                                        "biliary-tract"};
  return names.at(static_cast<std::size_t>(system));
}

std::optional<System> system_named(const std::string& name) {
  const auto* found =
      std::find_if(all_systems.begin(), all_systems.end(), [&](System system) { return name == system_name(system); });
  return found == all_systems.end() ? std::nullopt : std::optional<System>(*found);
}

const char* vessel_name(Vessel vessel) {
  static constexpr std::array<const char*, all_vessels.size()> names = {"portal-vein",         "hepatic-vein",
                                                                        "middle-hepatic-vein", "right-hepatic-vein",
                                                                        "umbilical-portion",   "left-hepatic-vein"};
  return names.at(static_cast<std::size_t>(vessel));
}

std::optional<Vessel> vessel_named(const std::string& name) {
  const auto* found =
      std::find_if(all_vessels.begin(), all_vessels.end(), [&](Vessel vessel) { return name == vessel_name(vessel); });
  return found == all_vessels.end() ? std::nullopt : std::optional<Vessel>(*found);
}

System system_of(Vessel vessel) {
  const bool portal = vessel == Vessel::portal_vein || vessel == Vessel::umbilical_portion;
  return portal ? System::portal_vein : System::hepatic_vein;
}

std::vector<VesselEntries> possible_entries(const VesselGraph& graph, const VesselEntries& expected,
                                            const Clicks& clicks, int each) {
  const double spread_mm = 18 * expected.scale;
  const auto places = [&](Vessel vessel, const Vector3d& expected_mm) {
    const auto click = std::find_if(clicks.rbegin(), clicks.rend(), [&](const Click& c) { return c.vessel == vessel; });
    return click != clicks.rend() ? std::vector<Vector3d>{click->position_mm}
                                  : thick_places(graph, expected_mm, spread_mm, each);
  };
  std::vector<VesselEntries> entries;
  for (const Vector3d& portal : places(Vessel::portal_vein, expected.portal_mm)) {
    for (const Vector3d& hepatic : places(Vessel::hepatic_vein, expected.hepatic_mm)) {
      if ((portal - hepatic).norm() > 15 * expected.scale) entries.push_back({portal, hepatic, expected.scale});
    }
  }
  if (entries.empty()) entries.push_back(expected);
  return entries;
}

VesselTrees classify_vessels(const VesselGraph& graph, const VesselEntries& entries,
                             const std::vector<Vector3d>& places_mm, const Clicks& clicks) {
  const ToldApart told = tell_apart(graph, entries, places_mm, clicks);
  VesselTrees trees{told.entries.portal_mm, told.entries.hepatic_mm, {}, clicks, {}, {}};
  for (const System system : vein_systems) {
    VesselGraph own{graph.vertices_mm, {}};
    std::vector<double> confidence;
    for (std::size_t b = 0; b < graph.branches.size(); ++b) {
      if (!told.belongs[b].at(static_cast<std::size_t>(system))) continue;
      own.branches.push_back(graph.branches[b]);
      confidence.push_back(told.confidence[b]);
    }
    const bool portal = system == System::portal_vein;
    const Growth growth(own, portal ? trees.portal_entry_mm : trees.hepatic_entry_mm);
    add_trees(own, system, growth.claims(), confidence, trees);
  }
  return trees;
}

VesselTrees known_vessels(const VesselGraph& portal, const VesselGraph& hepatic, const VesselEntries& entries) {
  VesselTrees trees{entries.portal_mm, entries.hepatic_mm, {}, {}, {}, {}};
  add_trees(portal, System::portal_vein, Growth(portal, entries.portal_mm).claims(), sure(portal), trees);
  add_trees(hepatic, System::hepatic_vein, Growth(hepatic, entries.hepatic_mm).claims(), sure(hepatic), trees);
  return trees;
}

void add_known_vessels(const VesselGraph& graph, System system, const imaging::Mask& liver, VesselTrees& trees) {
  for (const VesselGraph& piece : pieces_of(graph)) {
    const auto end = open_end(piece, liver);
    const Growth growth(piece, end ? piece.vertices_mm[static_cast<std::size_t>(*end)] : trees.portal_entry_mm);
    add_trees(piece, system, growth.claims(end), sure(piece), trees);
  }
}

}  // namespace glisson::vasculature
