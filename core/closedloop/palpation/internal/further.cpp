#include "closedloop/palpation/internal/further.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/result.h"
#include "base/units.h"

namespace glisson::closedloop {
namespace {

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

std::optional<Eigen::Vector3d> untouched_place(const Palpation& experiment, const PalpationTool& like,
                                               const std::vector<mechanics::BoundaryFace>& boundary) {
  std::optional<Eigen::Vector3d> place;
  double widest_mm = like.radius_mm;
  for (const mechanics::BoundaryFace& face : boundary) {
    if (std::abs(face.normal.dot(like.direction)) < 0.5) continue;
    // As high as the tools are: what looks the same way on the far side is what the specimen lies on.
    double gap_mm = std::numeric_limits<double>::infinity();
    for (const PalpationTrial& trial : experiment.trials) {
      gap_mm = std::min(gap_mm, (face.centroid_mm - trial.tool.center_mm).norm());
      if (std::abs((face.centroid_mm - trial.tool.center_mm).dot(like.direction)) > like.radius_mm) gap_mm = 0;
    }
    if (gap_mm > widest_mm) {
      widest_mm = gap_mm;
      place = face.centroid_mm;
    }
  }
  return place;
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
  if (const auto place = untouched_place(experiment, tool, boundary)) {
    PalpationTool elsewhere = tool;
    elsewhere.center_mm = *place;
    add({GLISSON_TEXT("Press at ({0}, {1}, {2}) mm with {3} N."),
         {whole(place->x()), whole(place->y()), whole(place->z()), short_figure(force_N)}},
        elsewhere, 1, 0);
  }
  add({GLISSON_TEXT("Press as in trial {0}, but with {1} N."), {base.trial->id, short_figure(2 * force_N)}}, tool, 2,
      0);
  add({GLISSON_TEXT("Press as in trial {0} and hold the force for {1} s."), {base.trial->id, whole(10 * longest_s)}},
      tool, 1, 10 * longest_s);
  add({GLISSON_TEXT("Pull where trial {0} presses, with {1} N."), {base.trial->id, short_figure(force_N)}}, tool, -1,
      0);
  return further;
}

}  // namespace glisson::closedloop
