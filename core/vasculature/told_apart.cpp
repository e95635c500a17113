#include "vasculature/internal/told_apart.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "vasculature/internal/forest.h"
#include "vasculature/internal/nearest_line.h"

namespace glisson::vasculature {

namespace {

using Eigen::Vector3d;

// Tuned on generated patients 1 to 10 (docs/territories.md).
constexpr std::uint64_t walks = 32;                  // many short ones: one that is stuck stays so however long it is
constexpr double of_distance = 2, farthest_mm = 30;  // a square millimetre of the mean squared distance, and its limit
constexpr double as_likely = 20;                     // energies this much higher count 1 / e for the confidence

const GraphBranch& branch_of(const VesselGraph& graph, const Junctions& junctions, std::size_t piece) {
  return graph.branches[static_cast<std::size_t>(junctions.pieces[piece].branch)];
}

// The mean over the places, both systems together, of the squared distance to the nearest line of each.
double squared_distance_mm2(const VesselGraph& graph, const Junctions& junctions, const Forest& forest,
                            const std::vector<Vector3d>& places_mm) {
  constexpr std::size_t stride = 4;
  std::array<std::vector<Vector3d>, 2> lines;
  for (std::size_t p = 0; p < junctions.pieces.size(); ++p) {
    const std::vector<CenterPoint>& points = branch_of(graph, junctions, p).points;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      lines.at(static_cast<std::size_t>(forest.system[p])).push_back(points[i].position_mm);
    }
  }
  double sum = 0;
  for (const Vector3d& place : places_mm) {
    for (const std::vector<Vector3d>& line : lines) {
      double nearest = farthest_mm * farthest_mm;
      for (const Vector3d& point : line) nearest = std::min(nearest, (point - place).squaredNorm());
      sum += nearest;
    }
  }
  return places_mm.empty() ? 0 : sum / static_cast<double>(places_mm.size());
}

// The pieces that somebody clicked on; of two clicks on one the later counts.
KnownPieces known_by(const VesselGraph& graph, const Junctions& junctions, const Clicks& clicks) {
  std::map<int, System> known;
  for (const Click& click : clicks) {
    const auto line_of = [&](std::size_t p) { return &branch_of(graph, junctions, p).points; };
    const int piece = nearest_line(junctions.pieces.size(), click.position_mm, line_of).number;
    if (piece >= 0) known.insert_or_assign(piece, system_of(click.vessel));
  }
  return {known.begin(), known.end()};
}

// The mean of the places where trees of each system begin, thick ones and near ones first.
VesselEntries entries_of(const Junctions& junctions, const Forest& forest, const VesselEntries& expected) {
  VesselEntries entries = expected;
  for (const System system : {System::portal_vein, System::hepatic_vein}) {
    Vector3d& entry = system == System::portal_vein ? entries.portal_mm : entries.hepatic_mm;
    const Vector3d near = entry;
    Vector3d sum = Vector3d::Zero();
    double weights = 0;
    for (std::size_t p = 0; p < forest.parent.size(); ++p) {
      if (forest.parent[p] >= 0 || forest.system[p] != system) continue;
      const PieceEnd& end = junctions.end(2 * static_cast<int>(p) + forest.near_end[p]);
      const double away = (end.position_mm - near).norm() / (25 * expected.scale);
      const double weight = std::pow(end.radius_mm, 3) * std::exp(-0.5 * away * away);
      sum += weight * end.position_mm;
      weights += weight;
    }
    if (weights > 0) entry = sum / weights;
  }
  return entries;
}

// Links go where blood passes over them; a stretch that none passes, with the thickest piece at it.
std::vector<std::array<bool, 2>> systems_of(const VesselGraph& graph, const Junctions& junctions,
                                            const Forest& forest) {
  std::vector<std::array<bool, 2>> belongs(graph.branches.size(), {false, false});
  std::vector<int> piece(graph.branches.size(), -1);
  for (std::size_t p = 0; p < junctions.pieces.size(); ++p) {
    const auto s = static_cast<std::size_t>(forest.system[p]);
    const auto b = static_cast<std::size_t>(junctions.pieces[p].branch);
    piece[b] = static_cast<int>(p);
    belongs[b].at(s) = true;
    if (forest.parent[p] < 0) continue;
    const int far = 2 * forest.parent[p] + 1 - forest.near_end[static_cast<std::size_t>(forest.parent[p])];
    const auto j = static_cast<std::size_t>(junctions.end(far).junction);
    const std::size_t way = junctions.between(far, 2 * static_cast<int>(p) + forest.near_end[p]);
    for (const int link : junctions.passages[j][way].branches) belongs[static_cast<std::size_t>(link)].at(s) = true;
  }
  const auto branches_at = graph.branches_at_vertices();
  for (std::size_t b = 0; b < belongs.size(); ++b) {
    const GraphBranch& branch = graph.branches[b];
    if (belongs[b][0] || belongs[b][1] || branch.joint != Joint::vessel) continue;
    double thickest = 0;
    std::size_t system = 0;
    for (const int vertex : {branch.from, branch.to}) {
      for (const int other : branches_at[static_cast<std::size_t>(vertex)]) {
        const int p = piece[static_cast<std::size_t>(other)];
        if (p < 0 || graph.branches[static_cast<std::size_t>(other)].radius_mm <= thickest) continue;
        thickest = graph.branches[static_cast<std::size_t>(other)].radius_mm;
        system = static_cast<std::size_t>(forest.system[static_cast<std::size_t>(p)]);
      }
    }
    belongs[b].at(system) = true;
  }
  return belongs;
}

}  // namespace

ToldApart tell_apart(const VesselGraph& graph, const VesselEntries& expected, const std::vector<Vector3d>& places_mm,
                     const Clicks& clicks) {
  const Junctions junctions = junctions_of(graph);
  VesselEntries entries = expected;
  for (const Click& click : clicks) {
    if (click.vessel == Vessel::portal_vein) entries.portal_mm = click.position_mm;
    if (click.vessel == Vessel::hepatic_vein) entries.hepatic_mm = click.position_mm;
  }
  if (junctions.pieces.empty()) return {std::vector<std::array<bool, 2>>(graph.branches.size()), {}, entries};
  const KnownPieces known = known_by(graph, junctions, clicks);
  std::vector<Forest> forests(walks);
  std::vector<double> costs(walks, 0);
  parallel_for(walks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      forests[n] = cooled_forest(junctions, entries, known, n + 1);
      costs[n] = forests[n].energy + of_distance * squared_distance_mm2(graph, junctions, forests[n], places_mm);
    }
  });
  const auto best = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  ToldApart told{systems_of(graph, junctions, forests[best]), std::vector<double>(graph.branches.size(), 1),
                 entries_of(junctions, forests[best], entries)};
  const std::vector<double> sure = sure_of(junctions, entries, known, forests[best]);
  for (std::size_t p = 0; p < junctions.pieces.size(); ++p) {
    double agreed = 0, all = 0;
    for (std::size_t n = 0; n < walks; ++n) {
      const double weight = std::exp((costs[best] - costs[n]) / as_likely);
      all += weight;
      if (forests[n].system[p] == forests[best].system[p]) agreed += weight;
    }
    told.confidence[static_cast<std::size_t>(junctions.pieces[p].branch)] = std::max(0.5, agreed / all * sure[p]);
  }
  return told;
}

}  // namespace glisson::vasculature
