#include "vasculature/couinaud.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/parallel.h"
#include "vasculature/internal/nearest_line.h"
#include "vasculature/internal/segment_evidence.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

struct Answer {
  PlaneParameters planes{};
  double energy = 0;
};
Answer descended(const Evidence& evidence, const PlaneParameters& start);
Answer most_probable(const Evidence& evidence);  // from several starts
// Where vessels enter, by what the shape alone says.
VesselEntries entries_of(const Evidence& evidence, const PlaneParameters& planes);
std::vector<PlaneParameters> others_as_likely(const Evidence& evidence, const PlaneParameters& best);

BentPlanes bent(const Evidence& evidence, const PlaneParameters& planes);
CouinaudSegments segments_of(const Mask& liver, const Evidence& evidence, const PlaneParameters& best);
void label(const Mask& liver, const Evidence& evidence, const PlaneParameters& best,
           const std::vector<PlaneParameters>& others, CouinaudSegments& segments);
std::vector<BorderDoubt> border_doubts(const Evidence& evidence, const PlaneParameters& best,
                                       const std::vector<PlaneParameters>& others);

}  // namespace

Result<CouinaudSegments> couinaud_segments(const Mask& liver, const VesselTrees* trees, const BorderPlaces& borders,
                                           const Progress& progress) {
  progress.report(0, GLISSON_TEXT("looking at the liver"));
  BorderPlaces all = trees != nullptr ? trees->borders : BorderPlaces();
  all.insert(all.end(), borders.begin(), borders.end());
  auto evidence = evidence_of(liver, all);
  if (!evidence) return failure(evidence.error());
  if (trees != nullptr && !trees->branches.empty()) {
    if (auto added = add_vessels(liver, *trees, *evidence); !added) return failure(std::move(added.error()));
  }
  progress.report(0.2, GLISSON_TEXT("finding the segments"));
  const PlaneParameters best = most_probable(*evidence).planes;
  if (progress.cancelled()) return cancelled();
  if (auto pass = evidence->hand.pass(SegmentPlanes(evidence->liver, best), liver.grid); !pass)
    return failure(std::move(pass.error()));
  CouinaudSegments segments = segments_of(liver, *evidence, best);
  progress.report(1, GLISSON_TEXT("done"));
  return segments;
}

Result<void> lie_on_vessels(const VesselGraph& graph, const Clicks& clicks) {
  constexpr double most_mm = 10;
  for (const Click& click : clicks) {
    const auto line_of = [&](std::size_t b) { return &graph.branches[b].points; };
    if (nearest_line(graph.branches.size(), click.position_mm, line_of).from_wall_mm <= most_mm) continue;
    const Vector3d& p = click.position_mm;
    return failure(
        "click-beside",
        GLISSON_TEXT("No vessel lies within {0} mm of {1}, where one was told: put the place on the vessel."),
        {fmt::format("{:.0f}", most_mm), fmt::format("{:.1f},{:.1f},{:.1f}", p.x(), p.y(), p.z())});
  }
  return {};
}

Result<LiverAnatomy> explain_vessels(const VesselGraph& graph, const Mask& liver, const Told& told,
                                     const Progress& progress) {
  progress.report(0, GLISSON_TEXT("looking at the liver"));
  if (auto on_vessels = lie_on_vessels(graph, told.clicks); !on_vessels) return failure(std::move(on_vessels.error()));
  auto evidence = evidence_of(liver, told.borders);
  if (!evidence) return failure(evidence.error());
  progress.report(0.2, GLISSON_TEXT("finding the segments"));
  const PlaneParameters by_shape = most_probable(*evidence).planes;
  LiverAnatomy anatomy;
  anatomy.trees = classify_vessels(graph, entries_of(*evidence, by_shape), evidence->places_mm, told.clicks);
  anatomy.trees.borders = told.borders;
  if (progress.cancelled()) return cancelled();
  if (auto added = add_vessels(liver, anatomy.trees, *evidence); !added) return failure(std::move(added.error()));
  const PlaneParameters best = descended(*evidence, by_shape).planes;
  const auto pass = evidence->hand.pass(SegmentPlanes(evidence->liver, best), liver.grid);
  if (!pass) return failure(pass.error());
  anatomy.segments = segments_of(liver, *evidence, best);
  name_branches(anatomy.trees, anatomy.segments);
  anatomy.trees.border_doubts = anatomy.segments.border_doubts;
  progress.report(1, GLISSON_TEXT("done"));
  return anatomy;
}

namespace {

BentPlanes bent(const Evidence& evidence, const PlaneParameters& planes) {
  return {SegmentPlanes(evidence.liver, planes), evidence.hand};
}

CouinaudSegments segments_of(const Mask& liver, const Evidence& evidence, const PlaneParameters& best) {
  CouinaudSegments segments;
  segments.from = evidence.vessels.empty() ? SegmentsFrom::shape : SegmentsFrom::trees;
  const std::vector<PlaneParameters> others = others_as_likely(evidence, best);
  label(liver, evidence, best, others, segments);
  segments.border_doubts = border_doubts(evidence, best, others);
  return segments;
}

// Places that other answers put beyond a border, from right to left: those of the sectors, and that of II and III.
std::vector<BorderDoubt> border_doubts(const Evidence& evidence, const PlaneParameters& best,
                                       const std::vector<PlaneParameters>& others) {
  static constexpr std::array<int, 9> sector = {0, 0, 1, 1, 2, 3, 4, 4, 3};
  std::vector<BorderDoubt> doubts = {{Vessel::umbilical_portion, 0},
                                     {Vessel::middle_hepatic_vein, 0},
                                     {Vessel::right_hepatic_vein, 0},
                                     {Vessel::left_hepatic_vein, 0}};
  const double place_ml = evidence.liver.volume_ml / static_cast<double>(evidence.places_mm.size());
  const BentPlanes planes = bent(evidence, best);
  for (const PlaneParameters& other : others) {
    const BentPlanes other_planes = bent(evidence, other);
    for (const Vector3d& place : evidence.places_mm) {
      const auto a = static_cast<std::size_t>(planes.at(place)), b = static_cast<std::size_t>(other_planes.at(place));
      if (a == 1 || b == 1 || a == b) continue;
      const double ml = place_ml / static_cast<double>(others.size());
      for (int s = std::min(sector[a], sector[b]); s < std::max(sector[a], sector[b]); ++s) {
        doubts[static_cast<std::size_t>(s - 1)].doubt_ml += ml;
      }
      if (sector[a] == 1 && sector[b] == 1) doubts.back().doubt_ml += ml;
    }
  }
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const BorderDoubt& a, const BorderDoubt& b) { return a.doubt_ml > b.doubt_ml; });
  return doubts;
}

// Downhill along one parameter after the other, in steps that shrink.
Answer descended(const Evidence& evidence, const PlaneParameters& start) {
  Answer answer{start, energy(evidence, start)};
  PlaneParameters step = plane_spread;
  for (int pass = 0; pass < 14; ++pass) {
    bool better = false;
    for (std::size_t n = 0; n < parameter_count; ++n) {
      for (const double way : {-0.7, 0.7}) {
        PlaneParameters tried = answer.planes;
        tried[n] += way * step[n];
        if (n >= caudate_width) tried[n] = std::max(4.0, tried[n]);
        const double offered = energy(evidence, tried);
        if (offered >= answer.energy - 1e-6) continue;
        answer = {tried, offered};
        better = true;
        break;
      }
    }
    if (!better) {
      for (double& s : step) s *= 0.55;
    }
  }
  return answer;
}

Answer most_probable(const Evidence& evidence) {
  Answer best;
  best.energy = 1e300;
  for (const double turned : {-0.8, 0.0, 0.8}) {
    PlaneParameters start = mean_planes;
    for (const Parameter n : {middle_deg, right_deg, left_deg}) start[n] += turned * plane_spread[n];
    Answer found = descended(evidence, start);
    if (found.energy < best.energy) best = found;
  }
  return best;
}

VesselEntries entries_of(const Evidence& evidence, const PlaneParameters& best) {
  const SegmentPlanes planes(evidence.liver, best);
  const double scale = evidence.liver.scale(), height = 0.5 * (best[anterior_height] + best[posterior_height]);
  return {planes.on_axis_mm(height) + scale * portal_from_axis,
          planes.on_axis_mm(hepatic_from_axis.z()) + scale * Vector3d(hepatic_from_axis.x(), hepatic_from_axis.y(), 0),
          scale};
}

// A walk that visits answers as often as they are probable (Metropolis et al. 1953, J Chem Phys 21:1087).
std::vector<PlaneParameters> others_as_likely(const Evidence& evidence, const PlaneParameters& best) {
  std::mt19937_64 engine(1);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<PlaneParameters> others;
  PlaneParameters now = best;
  double here = energy(evidence, now);
  for (int i = 0; i < 480; ++i) {
    PlaneParameters tried = now;
    const auto n = static_cast<std::size_t>(uniform() * static_cast<double>(mean_planes.size()));
    tried[n] += (uniform() - 0.5) * 2 * plane_spread[n];
    if (n >= caudate_width) tried[n] = std::max(4.0, tried[n]);
    const double there = energy(evidence, tried);
    if (std::log(std::max(1e-300, uniform())) < here - there) {
      now = tried;
      here = there;
    }
    if (i % 24 == 23) others.push_back(now);
  }
  return others;
}

void label(const Mask& liver, const Evidence& evidence, const PlaneParameters& best,
           const std::vector<PlaneParameters>& others, CouinaudSegments& segments) {
  const Grid& grid = liver.grid;
  segments.segment = {grid, std::vector<std::uint16_t>(liver.values.size(), 0)};
  segments.doubt.assign(liver.values.size(), 0);
  const BentPlanes planes = bent(evidence, best);
  std::vector<BentPlanes> other_planes;
  for (const PlaneParameters& other : others) other_planes.push_back(bent(evidence, other));
  // The doubt changes slowly: asked for once every few millimetres.
  std::array<int, 3> step{};
  for (int a = 0; a < 3; ++a) {
    step[static_cast<std::size_t>(a)] = std::max(1, static_cast<int>(std::lround(3 / grid.spacing_mm[a])));
  }
  const std::size_t layers = static_cast<std::size_t>((grid.size[2] + step[2] - 1) / step[2]);
  parallel_for(layers, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t layer = begin; layer < end; ++layer) {
      const int k0 = static_cast<int>(layer) * step[2];
      for (int j0 = 0; j0 < grid.size[1]; j0 += step[1]) {
        for (int i0 = 0; i0 < grid.size[0]; i0 += step[0]) {
          std::array<int, 9> votes{};
          bool asked = false;
          for (int k = k0; k < std::min(grid.size[2], k0 + step[2]); ++k) {
            for (int j = j0; j < std::min(grid.size[1], j0 + step[1]); ++j) {
              for (int i = i0; i < std::min(grid.size[0], i0 + step[0]); ++i) {
                if (liver.at(i, j, k) == 0) continue;
                if (!asked) {
                  const Vector3d p = grid.position_mm(i, j, k);
                  for (const BentPlanes& other : other_planes) ++votes[static_cast<std::size_t>(other.at(p))];
                  asked = true;
                }
                const int segment = planes.at(grid.position_mm(i, j, k));
                segments.segment.at(i, j, k) = static_cast<std::uint16_t>(segment);
                const int agreed = votes[static_cast<std::size_t>(segment)];
                const int all = std::max<int>(1, static_cast<int>(other_planes.size()));
                segments.doubt[grid.offset(i, j, k)] = static_cast<std::uint8_t>(100 * (all - agreed) / all);
              }
            }
          }
        }
      }
    }
  });
  measure(segments);
}

}  // namespace

const char* segment_name(std::size_t number) {
  static constexpr std::array<const char*, 9> names = {"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  return names.at(number);
}

const std::array<double, 3>& segment_colour(std::size_t number) {
  static constexpr std::array<std::array<double, 3>, 8> colours = {{{0.55, 0.55, 0.55},
                                                                    {0.90, 0.62, 0.00},
                                                                    {0.34, 0.71, 0.91},
                                                                    {0.00, 0.62, 0.45},
                                                                    {0.94, 0.89, 0.26},
                                                                    {0.00, 0.45, 0.70},
                                                                    {0.84, 0.37, 0.00},
                                                                    {0.80, 0.47, 0.65}}};
  return colours.at(number - 1);
}

void measure(CouinaudSegments& segments) {
  segments.volume_ml.fill(0);
  std::array<double, 9> doubts{};
  const double voxel_ml = segments.segment.grid.voxel_volume_mm3() / 1000;
  for (std::size_t i = 0; i < segments.segment.values.size(); ++i) {
    const std::size_t s = segments.segment.values[i];
    if (s == 0) continue;
    for (const std::size_t sum : {s, std::size_t{0}}) {
      segments.volume_ml[sum] += voxel_ml;
      doubts[sum] += voxel_ml * segments.doubt[i] / 100;
    }
  }
  for (std::size_t s = 0; s <= 8; ++s) {
    segments.confidence[s] = segments.volume_ml[s] > 0 ? 1 - doubts[s] / segments.volume_ml[s] : 0;
  }
}

Result<VesselEntries> expected_entries(const Mask& liver) {
  const auto evidence = evidence_of(liver, {});
  if (!evidence) return failure(evidence.error());
  return entries_of(*evidence, most_probable(*evidence).planes);
}

}  // namespace glisson::vasculature
