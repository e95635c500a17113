#include "vasculature/couinaud.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "base/parallel.h"
#include "segmentation/resample.h"
#include "vasculature/internal/segment_planes.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

// Of the liver's volume, and the standard deviation of its logarithm. VIII is the median of 107 livers, and the order
// of the others theirs (Mise et al. 2014, HPB 16:439); II with III 16 %, IV 17 %, the right side 65 % (Abdalla et al.
// 2004, Surgery 135:404).
constexpr std::array<double, 9> shares = {0, 0.03, 0.075, 0.085, 0.15, 0.13, 0.1, 0.17, 0.26};
constexpr std::array<double, 9> share_spread = {0, 0.5, 0.4, 0.5, 0.3, 0.35, 0.45, 0.3, 0.27};

// How much the rest counts, in units of the logarithm of the probability, and how exact it is; tuned on the tuning half
// of the real livers (docs/territories.md).
struct Weights {
  double cava = 3;                                      // a height at which the vena cava lies in a groove of the liver
  double umbilical_notch = 12, gall_bladder_notch = 6;  // a notch as deep as the liver
  double hepatic = 8;                                   // all hepatic veins together
  double portal = 8;                                    // all portal branches together
  double on_border_mm = 5;                              // how near a hepatic vein runs to a border
  double off_border_mm = 5;                             // how far from borders portal branches keep
  double most_off_border = 2;                           // beyond this a vein counts as none of those that part segments
  double entry_mm = 15;                                 // how exactly the places of entry are known
};
const Weights weights;

// Where the portal vein divides, from the vena cava's axis and the middle of the borders of V and VI, and where the
// hepatic veins meet, from the axis and the base point: means of generated patients 1 to 10, mm at scale 1.
const Vector3d portal_from_axis(-5, -27, 0), hepatic_from_axis(-10, -34, 57);

// A piece of vessel with what it counts as one of each system.
struct VesselSample {
  Vector3d position_mm;
  double hepatic_weight, portal_weight;
  bool left_portal;  // thick, and to the left of where the portal vein divides
};

// What is known of one liver.
struct Evidence {
  LiverFrame liver;
  std::vector<Vector3d> places_mm;  // spread over the liver
  std::vector<VesselSample> vessels;
  Vector3d portal_mm{0, 0, 0}, hepatic_mm{0, 0, 0};
  imaging::Mask coarse;  // the liver in cubes of 3 mm along the patient's axes

  [[nodiscard]] bool is_liver(const Vector3d& patient_mm) const {
    const Vector3d at = (patient_mm - coarse.grid.origin_mm) / coarse.grid.spacing_mm.x();
    const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y())),
              k = static_cast<int>(std::lround(at.z()));
    return coarse.grid.contains(i, j, k) && coarse.at(i, j, k) != 0;
  }
};

// Minus the logarithm of the probability, but for a constant.
double energy(const Evidence& evidence, const PlaneParameters& parameters);

struct Answer {
  PlaneParameters planes{};
  double energy = 0;
};
Answer descended(const Evidence& evidence, const PlaneParameters& start);
Answer most_probable(const Evidence& evidence);  // from several starts
// Where vessels enter, by what the shape alone says.
VesselEntries entries_of(const Evidence& evidence, const PlaneParameters& planes);
std::vector<PlaneParameters> others_as_likely(const Evidence& evidence, const PlaneParameters& best);

Result<Evidence> evidence_of(const Mask& liver);
Result<void> add_vessels(const Mask& liver, const VesselTrees& trees, Evidence& evidence);
CouinaudSegments segments_of(const Mask& liver, const Evidence& evidence, const PlaneParameters& best);
void label(const Mask& liver, const Evidence& evidence, const PlaneParameters& best,
           const std::vector<PlaneParameters>& others, CouinaudSegments& segments);

}  // namespace

Result<CouinaudSegments> couinaud_segments(const Mask& liver, const VesselTrees* trees, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("looking at the liver"));
  auto evidence = evidence_of(liver);
  if (!evidence) return failure(evidence.error());
  if (trees != nullptr && !trees->branches.empty()) {
    if (auto added = add_vessels(liver, *trees, *evidence); !added) return failure(std::move(added.error()));
  }
  progress.report(0.2, GLISSON_TEXT("finding the segments"));
  const PlaneParameters best = most_probable(*evidence).planes;
  if (progress.cancelled()) return cancelled();
  CouinaudSegments segments = segments_of(liver, *evidence, best);
  progress.report(1, GLISSON_TEXT("done"));
  return segments;
}

Result<LiverAnatomy> explain_vessels(const VesselGraph& graph, const Mask& liver, const Clicks& clicks,
                                     const Progress& progress) {
  progress.report(0, GLISSON_TEXT("looking at the liver"));
  const auto evidence = evidence_of(liver);
  if (!evidence) return failure(evidence.error());
  progress.report(0.2, GLISSON_TEXT("finding the segments"));
  const PlaneParameters by_shape = most_probable(*evidence).planes;
  const std::vector<VesselEntries> entries = possible_entries(graph, entries_of(*evidence, by_shape), clicks);
  struct Guess {
    VesselTrees trees;
    Evidence evidence;
    Answer answer;
    Result<void> added;
  };
  std::vector<Guess> guesses(entries.size());
  parallel_for(entries.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end && !progress.cancelled(); ++n) {
      Guess& guess = guesses[n];
      guess.trees = classify_vessels(graph, entries[n]);
      guess.evidence = *evidence;
      guess.added = add_vessels(liver, guess.trees, guess.evidence);
      guess.answer = descended(guess.evidence, by_shape);
    }
  });
  if (progress.cancelled()) return cancelled();
  const auto best = std::min_element(guesses.begin(), guesses.end(),
                                     [](const Guess& a, const Guess& b) { return a.answer.energy < b.answer.energy; });
  if (!best->added) return failure(best->added.error());
  LiverAnatomy anatomy{std::move(best->trees), segments_of(liver, best->evidence, best->answer.planes)};
  name_branches(anatomy.trees, anatomy.segments);
  progress.report(1, GLISSON_TEXT("done"));
  return anatomy;
}

namespace {

CouinaudSegments segments_of(const Mask& liver, const Evidence& evidence, const PlaneParameters& best) {
  CouinaudSegments segments;
  segments.from = evidence.vessels.empty() ? SegmentsFrom::shape : SegmentsFrom::trees;
  label(liver, evidence, best, others_as_likely(evidence, best), segments);
  return segments;
}

Result<Evidence> evidence_of(const Mask& liver) {
  Evidence evidence;
  auto frame = liver_frame(liver);
  if (!frame) return failure(std::move(frame.error()));
  evidence.liver = *frame;
  const Grid& grid = liver.grid;
  const double step_mm = std::cbrt(frame->volume_ml * 1000 / 1500);
  std::array<int, 3> step{};
  for (int a = 0; a < 3; ++a) {
    step[static_cast<std::size_t>(a)] = std::max(1, static_cast<int>(std::lround(step_mm / grid.spacing_mm[a])));
  }
  for (int k = step[2] / 2; k < grid.size[2]; k += step[2]) {
    for (int j = step[1] / 2; j < grid.size[1]; j += step[1]) {
      for (int i = step[0] / 2; i < grid.size[0]; i += step[0]) {
        if (liver.at(i, j, k) != 0) evidence.places_mm.push_back(grid.position_mm(i, j, k));
      }
    }
  }
  constexpr double cube_mm = 3;
  evidence.coarse.grid.spacing_mm.setConstant(cube_mm);
  evidence.coarse.grid.origin_mm = frame->low_mm;
  for (int a = 0; a < 3; ++a) {
    evidence.coarse.grid.size[static_cast<std::size_t>(a)] =
        static_cast<int>((frame->high_mm[a] - frame->low_mm[a]) / cube_mm) + 1;
  }
  evidence.coarse = segmentation::resample(liver, evidence.coarse.grid);
  return evidence;
}

Result<void> add_vessels(const Mask& liver, const VesselTrees& trees, Evidence& evidence) {
  const Grid& grid = liver.grid;
  const double scale = evidence.liver.scale();
  evidence.portal_mm = trees.portal_entry_mm;
  evidence.hepatic_mm = trees.hepatic_entry_mm;
  double inside = 0, all = 0;
  for (const TreeBranch& branch : trees.branches) {
    const double sure = 2 * branch.confidence - 1;
    constexpr std::size_t stride = 4;
    for (std::size_t i = 0; i + 1 < branch.points.size(); i += stride) {
      const CenterPoint& point = branch.points[i];
      const CenterPoint& next = branch.points[std::min(branch.points.size() - 1, i + stride)];
      const double length = (next.position_mm - point.position_mm).norm();
      const double counts = sure * length * std::clamp((point.radius_mm - 1.2) / 2, 0.0, 1.5);
      VesselSample sample{0.5 * (point.position_mm + next.position_mm), 0, 0, false};
      if (branch.system == System::hepatic_vein && (point.position_mm - evidence.hepatic_mm).norm() > 15 * scale) {
        sample.hepatic_weight = counts;
      } else if (branch.system == System::portal_vein && (point.position_mm - evidence.portal_mm).norm() > 25 * scale) {
        sample.portal_weight = counts;
        sample.left_portal = point.radius_mm > 2.5 && point.position_mm.x() > evidence.portal_mm.x() + 15 * scale &&
                             (point.position_mm - evidence.portal_mm).norm() < 75 * scale;
      }
      if (counts > 0) evidence.vessels.push_back(sample);
      const Vector3d at = grid.index_of(point.position_mm);
      const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y())),
                z = static_cast<int>(std::lround(at.z()));
      all += length;
      if (grid.contains(x, y, z) && liver.at(x, y, z) != 0) inside += length;
    }
  }
  double hepatic = 0, portal = 0;
  for (const VesselSample& sample : evidence.vessels) hepatic += sample.hepatic_weight, portal += sample.portal_weight;
  for (VesselSample& sample : evidence.vessels) {
    sample.hepatic_weight *= weights.hepatic / std::max(150.0, hepatic);
    sample.portal_weight *= weights.portal / std::max(150.0, portal);
  }
  if (inside < 0.5 * all) {
    return failure("vessels-outside",
                   GLISSON_TEXT("Only {0} % of the vessels lie in the liver: check that both masks are of one scan."),
                   {fmt::format("{:.0f}", all > 0 ? 100 * inside / all : 0)});
  }
  return {};
}

// The vena cava is no liver, but lies against it: how much of it does, summed over ten heights.
double groove(const Evidence& evidence, const SegmentPlanes& planes) {
  static constexpr std::array<std::array<double, 2>, 8> around = {
      {{1, 0}, {0.7071, 0.7071}, {0, 1}, {-0.7071, 0.7071}, {-1, 0}, {-0.7071, -0.7071}, {0, -1}, {0.7071, -0.7071}}};
  const double scale = evidence.liver.scale();
  double sum = 0;
  for (int n = 0; n < 10; ++n) {
    const Vector3d center = planes.on_axis_mm(-10 + 6 * n);
    double within = evidence.is_liver(center) ? 1 : 0, beside = 0;
    for (const auto& [x, y] : around) {
      const Vector3d way(x, y, 0);
      if (evidence.is_liver(center + 8 * scale * way)) within += 1;
      if (evidence.is_liver(center + 18 * scale * way)) beside += 1;
    }
    sum += beside / 8 - 1.3 * within / 9;
  }
  return sum;
}

// Under the liver the umbilical fissure and the gall bladder's fossa are notches: how much less liver lies in a surface
// through the axis than in those 14 degrees beside it.
double notch(const Evidence& evidence, const SegmentPlanes& planes, SegmentPlanes::Surface surface) {
  double sum = 0;
  for (int height = -40; height <= 0; height += 10) {
    for (int away = 30; away <= 90; away += 12) {
      const auto liver_at = [&](double turned_deg) {
        return evidence.is_liver(planes.on_surface_mm(surface, turned_deg, height, away)) ? 1.0 : 0.0;
      };
      sum += 0.5 * (liver_at(-14) + liver_at(14)) - 0.5 * (liver_at(-2) + liver_at(2));
    }
  }
  return sum / 30;
}

// What each of them adds.
enum Term : std::size_t {
  of_planes,
  of_volumes,
  of_groove,
  of_notches,
  of_entries,
  of_hepatic,
  of_left_portal,
  of_portal,
  term_count
};

std::array<double, term_count> terms(const Evidence& evidence, const PlaneParameters& parameters) {
  std::array<double, term_count> sum{};
  for (std::size_t n = 0; n < parameter_count; ++n) {
    const double off = (parameters[n] - mean_planes[n]) / plane_spread[n];
    sum[of_planes] += 0.5 * off * off;
  }
  const SegmentPlanes planes(evidence.liver, parameters);
  std::array<double, 9> counts{};
  for (const Vector3d& place : evidence.places_mm) ++counts[static_cast<std::size_t>(planes.at(place))];
  for (std::size_t s = 1; s <= 8; ++s) {
    const double share = std::max(0.002, counts[s] / static_cast<double>(evidence.places_mm.size()));
    const double off = std::log(share / shares[s]) / share_spread[s];
    sum[of_volumes] += 0.5 * off * off;
  }
  sum[of_groove] = -weights.cava * groove(evidence, planes);
  sum[of_notches] = -weights.umbilical_notch * notch(evidence, planes, SegmentPlanes::umbilical) -
                    weights.gall_bladder_notch * notch(evidence, planes, SegmentPlanes::middle);
  if (evidence.vessels.empty()) return sum;

  const double scale = evidence.liver.scale();
  const double height = 0.5 * (parameters[anterior_height] + parameters[posterior_height]);
  const Vector3d portal_off = planes.on_axis_mm(height) + scale * portal_from_axis - evidence.portal_mm;
  const Vector3d hepatic_off = planes.on_axis_mm(hepatic_from_axis.z()) +
                               scale * Vector3d(hepatic_from_axis.x(), hepatic_from_axis.y(), 0) - evidence.hepatic_mm;
  for (const Vector3d& off : {portal_off, hepatic_off}) {
    sum[of_entries] += std::min(4.0, 0.5 * off.squaredNorm() / (weights.entry_mm * weights.entry_mm * scale * scale));
  }
  for (const VesselSample& vessel : evidence.vessels) {
    const std::array<double, 4> away = planes.distances_mm(vessel.position_mm);
    const auto on = [&](double distance_mm) {
      const double off = distance_mm / (weights.on_border_mm * scale);
      return std::min(weights.most_off_border, 0.5 * off * off);
    };
    double least = std::min({std::abs(away[SegmentPlanes::middle]), std::abs(away[SegmentPlanes::right]),
                             std::abs(away[SegmentPlanes::umbilical])});
    // II and III part left of the umbilical fissure alone.
    if (away[SegmentPlanes::umbilical] < 0) least = std::min(least, std::abs(away[SegmentPlanes::left_vein]));
    sum[of_hepatic] += vessel.hepatic_weight * on(least);
    if (vessel.left_portal) {  // its umbilical part runs in the fissure
      sum[of_left_portal] += vessel.portal_weight * on(away[SegmentPlanes::umbilical]);
    } else {
      const double near = std::min(std::abs(away[SegmentPlanes::middle]), std::abs(away[SegmentPlanes::right])) /
                          (weights.off_border_mm * scale);
      sum[of_portal] += vessel.portal_weight * 2 * std::exp(-0.5 * near * near);
    }
  }
  return sum;
}

double energy(const Evidence& evidence, const PlaneParameters& parameters) {
  const std::array<double, term_count> all = terms(evidence, parameters);
  return std::accumulate(all.begin(), all.end(), 0.0);
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
  const SegmentPlanes planes(evidence.liver, best);
  std::vector<SegmentPlanes> other_planes;
  for (const PlaneParameters& other : others) other_planes.emplace_back(evidence.liver, other);
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
                  for (const SegmentPlanes& other : other_planes) ++votes[static_cast<std::size_t>(other.at(p))];
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
  std::array<double, 9> doubts{};
  const double voxel_ml = grid.voxel_volume_mm3() / 1000;
  for (std::size_t i = 0; i < liver.values.size(); ++i) {
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

}  // namespace

Result<VesselEntries> expected_entries(const Mask& liver) {
  const auto evidence = evidence_of(liver);
  if (!evidence) return failure(evidence.error());
  return entries_of(*evidence, most_probable(*evidence).planes);
}

void name_branches(VesselTrees& trees, const CouinaudSegments& segments) {
  static constexpr std::array<const char*, 9> portal_place = {"",
                                                              "left/caudate/I",
                                                              "left/lateral/II",
                                                              "left/lateral/III",
                                                              "left/medial/IV",
                                                              "right/anterior/V",
                                                              "right/posterior/VI",
                                                              "right/posterior/VII",
                                                              "right/anterior/VIII"};
  const Grid& grid = segments.segment.grid;
  // Where a branch and what grows from it run: millimetres in each segment.
  std::vector<std::array<double, 9>> in(trees.branches.size());
  for (std::size_t b = trees.branches.size(); b-- > 0;) {
    const TreeBranch& branch = trees.branches[b];
    for (const CenterPoint& point : branch.points) {
      const Vector3d at = grid.index_of(point.position_mm);
      const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y())),
                z = static_cast<int>(std::lround(at.z()));
      if (grid.contains(x, y, z)) ++in[b][segments.segment.at(x, y, z)];
    }
    if (branch.parent >= 0) {
      for (std::size_t s = 0; s <= 8; ++s) in[static_cast<std::size_t>(branch.parent)][s] += in[b][s];
    }
  }
  std::map<std::string, std::vector<std::size_t>> of_name;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const auto share = [&](std::initializer_list<std::size_t> some) {
      double sum = 0, all = 0;
      for (std::size_t s = 1; s <= 8; ++s) all += in[b][s];
      for (const std::size_t s : some) sum += in[b][s];
      return all > 0 ? sum / all : 0;
    };
    constexpr double most = 0.8;
    std::string name;
    if (trees.branches[b].system == System::portal_vein) {
      name = "portal";
      const auto largest = std::max_element(in[b].begin() + 1, in[b].end()) - in[b].begin();
      if (share({static_cast<std::size_t>(largest)}) >= most) {
        name += std::string("/") + portal_place.at(static_cast<std::size_t>(largest));
      } else if (share({5, 8}) >= most) {
        name += "/right/anterior";
      } else if (share({6, 7}) >= most) {
        name += "/right/posterior";
      } else if (share({5, 6, 7, 8}) >= most) {
        name += "/right";
      } else if (share({2, 3}) >= most) {
        name += "/left/lateral";
      } else if (share({1, 2, 3, 4}) >= most) {
        name += "/left";
      } else {
        name += "/stem";
      }
    } else {
      // By what it drains: the right vein V to VIII, the middle one IV with V and VIII, the left one II and III.
      const double left = share({2, 3}), posterior = share({6, 7});
      name = share({1}) > 0.6                  ? "hepatic/caudate"
             : left > 0.4                      ? "hepatic/left"
             : posterior > 0.25                ? "hepatic/right"
             : share({4}) > 0.1 || left > 0.05 ? "hepatic/middle"
                                               : "hepatic/right";
    }
    of_name[name].push_back(b);
  }
  for (auto& [name, branches] : of_name) {
    std::stable_sort(branches.begin(), branches.end(), [&](std::size_t a, std::size_t b) {
      return trees.branches[a].radius_mm > trees.branches[b].radius_mm;
    });
    for (std::size_t n = 0; n < branches.size(); ++n) {
      trees.branches[branches[n]].name = n == 0 ? name : fmt::format("{}/{}", name, n + 1);
    }
  }
}

}  // namespace glisson::vasculature
