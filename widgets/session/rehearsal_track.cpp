#include "widgets/session/rehearsal_track.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/result.h"

namespace glisson::widgets {

void RehearsalTrack::clear() { moments_.clear(); }

void RehearsalTrack::add(Moment moment, double clock_s) {
  const double rest_s = std::clamp(clock_s - last_clock_s_, 0.0, longest_rest_s);
  moment.time_s = moments_.empty() ? 0 : moments_.back().time_s + rest_s;
  last_clock_s_ = clock_s;
  moments_.push_back(std::move(moment));
  const auto contacts = std::count_if(moments_.begin(), moments_.end(), [](const Moment& m) { return m.contact; });
  if (static_cast<std::size_t>(contacts) > maximum_contacts) moments_.erase(moments_.begin());
}

void RehearsalTrack::replace_last(Moment moment) {
  GLISSON_ASSERT(!moments_.empty());
  moment.time_s = moments_.back().time_s;
  moments_.back() = std::move(moment);
}

std::size_t RehearsalTrack::at(double time_s) const {
  GLISSON_ASSERT(!moments_.empty());
  const auto after = std::upper_bound(moments_.begin(), moments_.end(), time_s,
                                      [](double time, const Moment& moment) { return time < moment.time_s; });
  return after == moments_.begin() ? 0 : static_cast<std::size_t>(after - moments_.begin()) - 1;
}

std::string RehearsalTrack::csv(const std::vector<std::string>& landmark_ids) const {
  std::string text = "time_s,tools,force_N,max_displacement_mm,atlas_off_mm";
  for (const std::string& id : landmark_ids) text += "," + id + "_mm";
  text += ",state,largest_strain,inverted_cells,error_bound_mm\n";
  for (const Moment& moment : moments_) {
    std::string tools;
    for (const PlacedTool& tool : moment.tools) {
      const Eigen::Vector3d pull_N = tool.pull_N();
      // Files speak English: not translated.
      tools += fmt::format("{}{} at {:.2f} {:.2f} {:.2f} mm with {:.3f} {:.3f} {:.3f} N", tools.empty() ? "" : "; ",
                           tool.preset, tool.center_mm.x(), tool.center_mm.y(), tool.center_mm.z(), pull_N.x(),
                           pull_N.y(), pull_N.z());
    }
    const mechanics::Validity& validity = moment.validity;
    const auto figure = [&](std::optional<double> length_mm) {
      return validity.usable() && length_mm && std::isfinite(*length_mm) ? fmt::format(",{:.4f}", *length_mm)
                                                                         : std::string(",");
    };
    text += fmt::format("{:.3f},{},{:.4f}", moment.time_s, tools, moment.force_N);
    text += figure(moment.max_displacement_mm) + figure(moment.reference_off_mm);
    for (const double displacement_mm : moment.landmarks_mm) text += figure(displacement_mm);
    text += fmt::format(",{},{:.4f},{}", to_string(validity.state()), validity.largest_strain, validity.inverted_cells);
    text += figure(moment.contact ? moment.contact->error_bound_mm : std::nullopt) + "\n";
  }
  return text;
}

Moment moment_of(std::vector<PlacedTool> tools, const rehearsal::RehearsalState& state) {
  Moment moment;
  moment.tools = std::move(tools);
  moment.force_N = state.force_N.norm();
  moment.max_displacement_mm = state.patient.max_displacement_mm;
  moment.validity = state.validity;
  if (state.reference) moment.reference_off_mm = state.max_difference_mm;
  for (const auto& landmark : state.patient.landmarks) moment.landmarks_mm.push_back(landmark.displacement_mm);
  return moment;
}

}  // namespace glisson::widgets
