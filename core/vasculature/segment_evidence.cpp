#include "vasculature/internal/segment_evidence.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "vasculature/internal/nearest_line.h"
#include "vasculature/internal/nearest_voxel.h"

namespace glisson::vasculature {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

namespace {

// Of the liver's volume, and the standard deviation of its logarithm, wide, so that a small segment stays small. VIII
// is the median of 107 livers, and the order of the others theirs (Mise et al. 2014, HPB 16:439); II with III 16 %, IV
// 17 %, the right side 65 % (Abdalla et al. 2004, Surgery 135:404).
constexpr std::array<double, 9> shares = {0, 0.03, 0.075, 0.085, 0.15, 0.13, 0.1, 0.17, 0.26};
constexpr std::array<double, 9> share_spread = {0, 0.8, 0.63, 0.8, 0.47, 0.55, 0.7, 0.47, 0.43};

// How much the rest counts, in units of the logarithm of the probability, and how exact it is; tuned on the tuning half
// of the real livers (docs/territories.md).
struct Weights {
  double hepatic = 5;             // all hepatic veins together
  double portal = 5;              // all portal branches together
  double named = 10;              // one vessel that somebody named
  double on_border_mm = 5;        // how near a hepatic vein runs to a border
  double off_border_mm = 5;       // how far from borders portal branches keep
  double maximum_off_border = 2;  // beyond this a vein counts as none of those that part segments
  double entry_mm = 25;           // how exactly the places of entry are known
};
const Weights weights;

// What each of them adds.
enum Term : std::size_t {
  of_planes,
  of_volumes,
  of_entries,
  of_hepatic,
  of_left_portal,
  of_portal,
  of_named,
  of_hand,
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
  sum[of_hand] = evidence.hand.energy(planes);
  if (evidence.vessels.empty()) return sum;

  const double scale = evidence.liver.scale();
  const double height = 0.5 * (parameters[anterior_height] + parameters[posterior_height]);
  const Vector3d portal_off = planes.on_axis_mm(height) + scale * portal_from_axis - evidence.portal_mm;
  const Vector3d hepatic_off = planes.on_axis_mm(hepatic_from_axis.z()) +
                               scale * Vector3d(hepatic_from_axis.x(), hepatic_from_axis.y(), 0) - evidence.hepatic_mm;
  for (const Vector3d& off : {portal_off, hepatic_off}) {
    sum[of_entries] += std::min(4.0, 0.5 * off.squaredNorm() / (weights.entry_mm * weights.entry_mm * scale * scale));
  }
  const auto on = [&](double distance_mm) {
    const double off = distance_mm / (weights.on_border_mm * scale);
    return std::min(weights.maximum_off_border, 0.5 * off * off);
  };
  for (const BorderSample& sample : evidence.borders) {
    sum[of_named] += sample.weight * on(planes.levels_mm(sample.position_mm)[sample.border]);
  }
  for (const VesselSample& vessel : evidence.vessels) {
    const SurfaceLevels away = planes.levels_mm(vessel.position_mm);
    double nearest =
        std::min({std::abs(away[middle_vein]), std::abs(away[right_vein]), std::abs(away[umbilical_fissure])});
    // II and III part left of the umbilical fissure alone.
    if (away[umbilical_fissure] < 0) nearest = std::min(nearest, std::abs(away[left_vein]));
    sum[of_hepatic] += vessel.hepatic_weight * on(nearest);
    if (vessel.left_portal) {  // its umbilical part runs in the fissure
      sum[of_left_portal] += vessel.portal_weight * on(away[umbilical_fissure]);
    } else {
      const double near =
          std::min(std::abs(away[middle_vein]), std::abs(away[right_vein])) / (weights.off_border_mm * scale);
      sum[of_portal] += vessel.portal_weight * 2 * std::exp(-0.5 * near * near);
    }
  }
  return sum;
}

std::optional<Surface> border_along(Vessel vessel) {
  switch (vessel) {
    case Vessel::middle_hepatic_vein: return middle_vein;
    case Vessel::right_hepatic_vein: return right_vein;
    case Vessel::umbilical_portion: return umbilical_fissure;
    case Vessel::left_hepatic_vein: return left_vein;
    default: return {};
  }
}

// The borders along the branches that somebody clicked on by name.
void add_named(const VesselTrees& trees, Evidence& evidence) {
  for (const Click& click : trees.clicks) {
    const auto border = border_along(click.vessel);
    const auto line_of = [&](std::size_t b) {
      return trees.branches[b].system == system_of(click.vessel) ? &trees.branches[b].points : nullptr;
    };
    const int nearest = nearest_line(trees.branches.size(), click.position_mm, line_of).number;
    if (!border || nearest < 0) continue;
    const std::vector<CenterPoint>& points = trees.branches[static_cast<std::size_t>(nearest)].points;
    constexpr std::size_t stride = 2;
    const std::size_t count = (points.size() + stride - 1) / stride;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      evidence.borders.push_back({points[i].position_mm, *border, weights.named / static_cast<double>(count)});
    }
  }
}

}  // namespace

Result<Evidence> evidence_of(const Mask& liver, const BorderPlaces& borders) {
  Evidence evidence;
  auto frame = liver_frame(liver);
  if (!frame) return failure(std::move(frame.error()));
  evidence.liver = *frame;
  if (auto inside = lie_in_liver(liver, borders); !inside) return failure(std::move(inside.error()));
  const Grid& grid = liver.grid;
  evidence.hand = HandBorders(borders, frame->scale(), std::max(2.0, 0.5 * grid.spacing_mm.norm()));
  const auto may_pass = evidence.hand.may_pass(SegmentPlanes(*frame, mean_planes));
  if (!may_pass) return failure(may_pass.error());
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
  return evidence;
}

Result<void> add_vessels(const Mask& liver, const VesselTrees& trees, Evidence& evidence) {
  const double scale = evidence.liver.scale();
  evidence.portal_mm = trees.portal_entry_mm;
  evidence.hepatic_mm = trees.hepatic_entry_mm;
  double inside = 0, all = 0;
  for (const TreeBranch& branch : trees.branches) {
    if (!is_vein(branch.system)) continue;
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
      const auto voxel = nearest_voxel(liver.grid, point.position_mm);
      all += length;
      if (voxel && liver.values[*voxel] != 0) inside += length;
    }
  }
  double hepatic = 0, portal = 0;
  for (const VesselSample& sample : evidence.vessels) hepatic += sample.hepatic_weight, portal += sample.portal_weight;
  for (VesselSample& sample : evidence.vessels) {
    sample.hepatic_weight *= weights.hepatic / std::max(150.0, hepatic);
    sample.portal_weight *= weights.portal / std::max(150.0, portal);
  }
  add_named(trees, evidence);
  if (inside < 0.5 * all) {
    return failure("vessels-outside",
                   GLISSON_TEXT("Only {0} % of the vessels lie in the liver: check that both masks are of one scan."),
                   {fmt::format("{:.0f}", all > 0 ? 100 * inside / all : 0)});
  }
  return {};
}

double energy(const Evidence& evidence, const PlaneParameters& parameters) {
  const std::array<double, term_count> all = terms(evidence, parameters);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

}  // namespace glisson::vasculature
