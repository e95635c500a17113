#include "closedloop/palpation/internal/loading.h"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "closedloop/palpation/internal/history.h"
#include "mechanics/elements/load_vector.h"

namespace glisson::closedloop {

Loading loading_of(const std::vector<Shot>& all, const std::vector<History>& histories, const LoadColumns& columns,
                   const Eigen::Vector3d& gravity_mm_s2, const PalpationState& state) {
  const auto shots = static_cast<Eigen::Index>(all.size());
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(columns.all(), shots);
  Loading loading{none, none, none, {state.creep.size(), none}, {state.creep.size(), none}};
  for (std::size_t t = 0; t < histories.size(); ++t) {
    const History& history = histories[t];
    const Eigen::VectorXd force_mN = (history.reading_mN.array() - state.zero_mN) / state.gain;
    const Eigen::VectorXd effective_mN = effective_load(history.time_s, force_mN, state.creep);
    const Eigen::VectorXd of_one = effective_load(history.time_s, Eigen::VectorXd::Ones(force_mN.size()), state.creep);
    std::vector<DelayedLoad> delayed;
    for (const CreepTerm& term : state.creep) delayed.push_back(delayed_load(history.time_s, force_mN, term.time_s));
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (all[s].trial != t) continue;
      const auto shot = static_cast<Eigen::Index>(s);
      const Eigen::Index i = all[s].sample;
      loading.amounts(history.load, shot) = effective_mN[i];
      loading.by_zero(history.load, shot) = -of_one[i] / state.gain;
      loading.by_gain(history.load, shot) = -effective_mN[i] / state.gain;
      for (std::size_t c = 0; c < delayed.size(); ++c) {
        loading.by_amplitude[c](history.load, shot) = delayed[c].value[i];
        loading.by_time[c](history.load, shot) = state.creep[c].amplitude * delayed[c].by_time[i];
      }
    }
  }
  loading.amounts.middleRows<3>(columns.gravity()).colwise() += gravity_mm_s2 + state.gravity_mm_s2;
  loading.amounts.row(columns.pressure()).array() += state.pressure_kPa;
  return loading;
}

Result<std::vector<History>> histories_and_loads(const Palpation& experiment, const SpecimenBody& specimen,
                                                 LoadColumns& columns, Eigen::MatrixXd& loads_mN) {
  const mechanics::Body& body = specimen.body;
  std::vector<mechanics::ToolLoad> tools;
  std::vector<Eigen::VectorXd> forces;
  const auto add = [&](const mechanics::Load& load) -> Result<void> {
    return mechanics::load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, {load})
        .map([&](Eigen::VectorXd force_mN) { forces.push_back(std::move(force_mN)); });
  };
  std::vector<History> histories;
  for (const PalpationTrial& trial : experiment.trials) {
    History history;
    const auto samples = static_cast<Eigen::Index>(trial.samples.size());
    history.time_s.resize(samples);
    history.reading_mN.resize(samples);
    for (Eigen::Index s = 0; s < samples; ++s) {
      history.time_s[s] = trial.samples[static_cast<std::size_t>(s)].time_s;
      history.reading_mN[s] = trial.samples[static_cast<std::size_t>(s)].force_mN;
    }
    const mechanics::ToolLoad tool{trial.tool.center_mm, trial.tool.radius_mm, trial.tool.direction};
    const auto known = std::find_if(tools.begin(), tools.end(), [&](const mechanics::ToolLoad& other) {
      return other.center_mm == tool.center_mm && other.radius_mm == tool.radius_mm && other.force_mN == tool.force_mN;
    });
    history.load = known - tools.begin();
    if (known == tools.end()) {
      if (auto added = add(tool); !added) {
        Error error = std::move(added.error());
        error.text = fmt::format("Trial {}: {}", trial.id, error.message());
        error.arguments.clear();
        return failure(std::move(error));
      }
      tools.push_back(tool);
    }
    histories.push_back(std::move(history));
  }
  columns.tools = static_cast<Eigen::Index>(tools.size());
  for (int d = 0; d < 3; ++d) {
    if (auto added = add(mechanics::GravityLoad{Eigen::Vector3d::Unit(d)}); !added) return failure(added.error());
  }
  if (auto added = add(mechanics::PressureLoad{1.0}); !added) return failure(added.error());
  loads_mN.resize(3 * static_cast<Eigen::Index>(body.layout.nodes()), columns.all());
  for (std::size_t l = 0; l < forces.size(); ++l) loads_mN.col(static_cast<Eigen::Index>(l)) = forces[l];
  return histories;
}

}  // namespace glisson::closedloop
