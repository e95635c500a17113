#include "closedloop/palpation/internal/marker_rows.h"

#include <array>
#include <map>

#include "base/units.h"
#include "closedloop/palpation/internal/frame.h"

namespace glisson::closedloop {

Result<MarkerRows> marker_rows(const Palpation& experiment) {
  MarkerRows seen;
  seen.observations.unit = "mm";
  seen.observations.directions = {"x", "y", "z"};
  std::vector<Observation> rows;
  std::map<std::array<double, 3>, Eigen::Index> known_places;
  for (std::size_t t = 0; t < experiment.trials.size(); ++t) {
    const PalpationTrial& trial = experiment.trials[t];
    seen.observations.trials.push_back(trial.id);
    for (std::size_t s = 0; s < trial.samples.size(); ++s) {
      const PalpationSample& sample = trial.samples[s];
      if (sample.markers.empty()) continue;
      Shot shot{t, static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(rows.size()), {}};
      for (const Marker& marker : sample.markers) {
        const auto& at = marker.rest_mm;
        const auto [place, is_new] =
            known_places.try_emplace({at.x(), at.y(), at.z()}, static_cast<Eigen::Index>(seen.places_mm.size()));
        if (is_new) seen.places_mm.push_back(at);
        shot.markers.push_back(place->second);
        const int point = static_cast<int>(rows.size() / 3);
        const Eigen::Vector3d& tool_mm = trial.tool.center_mm;
        for (int d = 0; d < 3; ++d) {
          rows.push_back({.measured = marker.position_mm[d] - at[d],
                          .noise = experiment.noise_mm,
                          .trial = static_cast<int>(t),
                          .sample = static_cast<int>(s),
                          .direction = d,
                          .point = point,
                          .time_s = sample.time_s,
                          .load = units::N_from_mN(sample.force_mN),
                          .place_mm = at,
                          .conditions = {tool_mm.x(), tool_mm.y(), tool_mm.z()}});
        }
      }
      seen.shots.push_back(std::move(shot));
    }
  }
  if (rows.empty()) return failure("no-measurement", GLISSON_TEXT("No sample of the experiment has markers."));

  seen.observations.add(rows);
  return seen;
}

Eigen::VectorXd MarkerRows::seen(const PalpationState& state, const Eigen::MatrixXd& displacements_mm) const {
  const Eigen::Matrix3d turn_less_one = rotation(state.rotation_deg) - Eigen::Matrix3d::Identity();
  return rows([&](Eigen::Index place, Eigen::Index shot) -> Eigen::Vector3d {
    const Eigen::Vector3d u = displacements_mm.col(shot).segment<3>(3 * place);
    return u + turn_less_one * (places_mm[static_cast<std::size_t>(place)] + u) + state.translation_mm;
  });
}

}  // namespace glisson::closedloop
