#include "closedloop/palpation/internal/further.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/result.h"
#include "base/units.h"

namespace glisson::closedloop {
namespace {

constexpr std::size_t most_places = 6;             // each takes a solve of every standing explanation
constexpr double clear_of_edges = 0.7;             // of the tool's radius
constexpr double farthest_share = 0.3;             // that a marker is moved, of the specimen's smallest extent
constexpr double tilt_rad = std::numbers::pi / 6;  // more and a tool slips

std::string whole(double value) { return fmt::format("{:.0f}", value); }
std::string short_figure(double value) { return fmt::format("{:.2g}", value); }

struct Furthest {
  const PalpationTrial* trial = nullptr;
  const PalpationSample* sample = nullptr;
};
Furthest furthest(const Palpation& experiment) {
  Furthest found;
  for (const PalpationTrial& trial : experiment.trials) {
    for (const PalpationSample& sample : trial.samples) {
      if (sample.markers.empty()) continue;
      if (found.sample == nullptr || std::abs(sample.force_mN) > std::abs(found.sample->force_mN))
        found = {&trial, &sample};
    }
  }
  return found;
}

// Whether the surface looks as the tool does.
bool faces(const mechanics::BoundaryFace& face, const PalpationTool& tool) {
  return std::abs(face.normal.dot(tool.direction)) >= 0.5;
}

// From there to where the surface turns away from the tool.
double to_edge_mm(const std::vector<mechanics::BoundaryFace>& boundary, const Eigen::Vector3d& place_mm,
                  const PalpationTool& tool) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const mechanics::BoundaryFace& face : boundary)
    if (!faces(face, tool)) nearest_mm = std::min(nearest_mm, (face.centroid_mm - place_mm).norm());
  return nearest_mm;
}

// Middles of faces, each as far as can be from all tools and from those before it, and further than a tool is wide. At
// an edge the tool would hang over it: there the declared mesh errs most.
std::vector<Eigen::Vector3d> untouched_places(const Palpation& experiment, const PalpationTool& like,
                                              const std::vector<mechanics::BoundaryFace>& boundary) {
  std::vector<Eigen::Vector3d> candidates;
  std::vector<double> gaps_mm;
  for (const mechanics::BoundaryFace& face : boundary) {
    if (!faces(face, like)) continue;
    // As high as the tools are: what looks the same way on the far side is what the specimen lies on.
    double gap_mm = std::numeric_limits<double>::infinity();
    for (const PalpationTrial& trial : experiment.trials) {
      gap_mm = std::min(gap_mm, (face.centroid_mm - trial.tool.center_mm).norm());
      if (std::abs((face.centroid_mm - trial.tool.center_mm).dot(like.direction)) > like.radius_mm) gap_mm = 0;
    }
    candidates.push_back(face.centroid_mm);
    gaps_mm.push_back(gap_mm);
  }
  std::vector<Eigen::Vector3d> places;
  while (places.size() < most_places) {
    const auto widest = std::max_element(gaps_mm.begin(), gaps_mm.end());
    if (widest == gaps_mm.end() || *widest <= like.radius_mm) break;
    const auto place = static_cast<std::size_t>(widest - gaps_mm.begin());
    if (to_edge_mm(boundary, candidates[place], like) < clear_of_edges * like.radius_mm) {
      *widest = 0;
      continue;
    }
    places.push_back(candidates[place]);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      gaps_mm[i] = std::min(gaps_mm[i], (candidates[i] - places.back()).norm());
  }
  return places;
}

// Whether twice as much would still be a palpation: no marker moved by more than a share of the specimen's smallest
// extent.
bool moves_little(const Palpation& experiment, const PalpationSample& sample) {
  const geometry::Box box = geometry::bounding_box(experiment.mesh.points_mm);
  const double allowed_mm = 0.5 * farthest_share * (box.max_mm - box.min_mm).minCoeff();
  return std::all_of(sample.markers.begin(), sample.markers.end(),
                     [&](const Marker& marker) { return (marker.position_mm - marker.rest_mm).norm() <= allowed_mm; });
}

// The tool's direction, tilted towards one of two directions across it.
Eigen::Vector3d tilted(const Eigen::Vector3d& direction, bool second) {
  const Eigen::Vector3d one = direction.unitOrthogonal();
  const Eigen::Vector3d across = second ? Eigen::Vector3d(direction.cross(one)) : one;
  return std::cos(tilt_rad) * direction + std::sin(tilt_rad) * across;
}

}  // namespace

std::vector<FurtherPalpation> further_palpations(const Palpation& experiment,
                                                 const std::vector<mechanics::BoundaryFace>& boundary) {
  const Furthest base = furthest(experiment);
  if (base.sample == nullptr || base.sample->force_mN == 0) return {};
  const double force_N = units::N_from_mN(base.sample->force_mN);
  const double reached_s = std::max(base.sample->time_s - base.trial->samples.front().time_s, 1.0);
  double longest_s = reached_s;
  for (const PalpationTrial& trial : experiment.trials)
    longest_s = std::max(longest_s, trial.samples.back().time_s - trial.samples.front().time_s);

  std::vector<FurtherPalpation> further;
  const auto add = [&](Sentence sentence, const PalpationTool& tool, double times, double hold_s) {
    PalpationSample before, after = *base.sample;
    after.force_mN *= times;
    after.time_s = reached_s;
    std::vector<PalpationSample> samples{before, after};
    if (hold_s > 0) {
      samples[1].markers.clear();
      samples.push_back(after);
      samples.back().time_s = hold_s;
    }
    further.push_back({std::move(sentence), {fmt::format("further-{}", further.size() + 1), tool, std::move(samples)}});
  };
  const PalpationTool& tool = base.trial->tool;
  const std::vector<Eigen::Vector3d> places = untouched_places(experiment, tool, boundary);
  const auto at = [&](const Eigen::Vector3d& place) { return PalpationTool{place, tool.radius_mm, tool.direction}; };
  const auto press_at = [&](const Eigen::Vector3d& place, double times) {
    add({GLISSON_TEXT("Press at ({0}, {1}, {2}) mm with {3} N."),
         {whole(place.x()), whole(place.y()), whole(place.z()), short_figure(times * force_N)}},
        at(place), times, 0);
  };
  const bool bears_twice = moves_little(experiment, *base.sample);
  if (!places.empty()) press_at(places.front(), 1);
  if (bears_twice)
    add({GLISSON_TEXT("Press as in trial {0}, but with {1} N."), {base.trial->id, short_figure(2 * force_N)}}, tool, 2,
        0);
  add({GLISSON_TEXT("Press as in trial {0} and hold the force for {1} s."), {base.trial->id, whole(10 * longest_s)}},
      tool, 1, 10 * longest_s);
  add({GLISSON_TEXT("Pull where trial {0} presses, with {1} N."), {base.trial->id, short_figure(force_N)}}, tool, -1,
      0);
  for (std::size_t i = 1; i < places.size(); ++i) press_at(places[i], 1);
  for (const bool second : {false, true}) {
    PalpationTool oblique = tool;
    oblique.direction = tilted(tool.direction, second);
    add({GLISSON_TEXT("Press where trial {0} presses, with {1} N along ({2}, {3}, {4})."),
         {base.trial->id, short_figure(force_N), short_figure(oblique.direction.x()),
          short_figure(oblique.direction.y()), short_figure(oblique.direction.z())}},
        oblique, 1, 0);
  }
  if (places.empty()) return further;
  const Eigen::Vector3d& new_place = places.front();
  if (bears_twice) press_at(new_place, 2);
  add({GLISSON_TEXT("Press at ({0}, {1}, {2}) mm with {3} N and hold the force for {4} s."),
       {whole(new_place.x()), whole(new_place.y()), whole(new_place.z()), short_figure(force_N),
        whole(10 * longest_s)}},
      at(new_place), 1, 10 * longest_s);
  return further;
}

}  // namespace glisson::closedloop
