#include "closedloop/material/model.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/json.h"
#include "closedloop/material/effects.h"

namespace glisson::closedloop {
namespace {

class MaterialModel : public ForwardModel {
 public:
  explicit MaterialModel(Material material);

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override;
  [[nodiscard]] std::vector<FurtherTrial> further_trials() const override;
  [[nodiscard]] Result<Eigen::VectorXd> predict_further(const Settings& settings) const override;

 private:
  [[nodiscard]] MaterialBehaviour behaviour(const Settings& settings) const;

  struct FurtherRamp {
    Sentence sentence;
    Eigen::VectorXd time_s;
    Eigen::VectorXd stretch;
  };
  [[nodiscard]] std::vector<FurtherRamp> further() const;

  Material material_;
  std::vector<MaterialEffect> effects_;  // also those that these trials could not show
  std::vector<Effect> catalogue_;
  Observations observations_;
};

Observations observations_of(const Material& material);

}  // namespace

Result<std::unique_ptr<ForwardModel>> material_model(Material material) {
  return std::make_unique<MaterialModel>(std::move(material));
}

namespace {

MaterialModel::MaterialModel(Material material)
    : material_(std::move(material)),
      effects_(known_material_effects(material_)),
      observations_(observations_of(material_)) {
  for (MaterialEffect& effect : material_effects(material_)) catalogue_.push_back(std::move(effect.effect));
}

MaterialBehaviour MaterialModel::behaviour(const Settings& settings) const {
  MaterialBehaviour behaviour;
  behaviour.mode = material_.mode;
  behaviour.young_kPa = material_.young_kPa;
  behaviour.law = material_.law == DeclaredLaw::linear ? ElasticLaw::linear : ElasticLaw::neo_hookean;
  for (const Setting& setting : settings) {
    const auto found = std::find_if(effects_.begin(), effects_.end(), [&](const MaterialEffect& effect) {
      return effect.effect.kind == setting.kind && effect.effect.form == setting.form;
    });
    GLISSON_ASSERT(found != effects_.end());
    found->apply(setting.parameters, behaviour);
  }
  return behaviour;
}

Result<Eigen::VectorXd> MaterialModel::predict(const Settings& settings) const {
  const MaterialBehaviour specimen = behaviour(settings);
  Eigen::VectorXd predicted(observations_.rows());
  Eigen::Index row = 0;
  for (const MaterialTrial& trial : material_.trials) {
    predicted.segment(row, trial.time_s.size()) = reading_kPa(specimen, trial.time_s, trial.stretch);
    row += trial.time_s.size();
  }
  if (!predicted.allFinite())
    return failure("material-out-of-range", GLISSON_TEXT("The material law is used beyond the stretch it allows."));
  return predicted;
}

std::vector<FurtherTrial> MaterialModel::further_trials() const {
  std::vector<FurtherTrial> trials;
  for (const FurtherRamp& ramp : further()) {
    Json conditions{{"id", fmt::format("next-{}", trials.size() + 1)},
                    {"time_s", std::vector<double>(ramp.time_s.begin(), ramp.time_s.end())},
                    {"stretch", std::vector<double>(ramp.stretch.begin(), ramp.stretch.end())}};
    trials.push_back({ramp.sentence, std::make_shared<const Json>(std::move(conditions)), ramp.time_s.size()});
  }
  return trials;
}

Result<Eigen::VectorXd> MaterialModel::predict_further(const Settings& settings) const {
  const MaterialBehaviour specimen = behaviour(settings);
  Eigen::VectorXd all;
  for (const FurtherRamp& ramp : further()) {
    const Eigen::Index before = all.size();
    all.conservativeResize(before + ramp.time_s.size());
    all.tail(ramp.time_s.size()) = reading_kPa(specimen, ramp.time_s, ramp.stretch) / material_.noise_kPa;
  }
  return all;
}

// A slow ramp, a fast one, one that is held, two cycles, and the other side of rest: what a testing machine does.
std::vector<MaterialModel::FurtherRamp> MaterialModel::further() const {
  double strain = 0;
  double seconds = 1;
  for (const MaterialTrial& trial : material_.trials) {
    for (const double stretch : trial.stretch) {
      if (std::abs(stretch - 1) > std::abs(strain)) strain = stretch - 1;
    }
    if (trial.time_s.size() > 1) seconds = std::max(seconds, trial.time_s[trial.time_s.size() - 1] - trial.time_s[0]);
  }
  constexpr Eigen::Index samples = 100;
  const auto trial = [&](const char* sentence, double duration_s, double reach, auto&& shape) {
    FurtherRamp made{{sentence, {}}, Eigen::VectorXd::LinSpaced(samples, 0, duration_s), {}};
    made.stretch = Eigen::VectorXd::NullaryExpr(
        samples, [&](Eigen::Index i) { return 1 + reach * shape(double(i) / double(samples - 1)); });
    return made;
  };
  const auto ramp = [](double x) { return x; };
  const auto held = [](double x) { return std::min(1.0, 20 * x); };
  const auto cycles = [](double x) { return 1 - std::abs(1 - std::fmod(4 * x, 2.0)); };
  std::vector<FurtherRamp> trials;
  trials.push_back(trial(GLISSON_TEXT("Deform ten times as slowly."), 10 * seconds, strain, ramp));
  trials.push_back(trial(GLISSON_TEXT("Deform ten times as fast."), seconds / 10, strain, ramp));
  trials.push_back(
      trial(GLISSON_TEXT("Deform quickly and hold for the length of the longest trial."), seconds, strain, held));
  trials.push_back(trial(GLISSON_TEXT("Load and unload twice."), 4 * seconds, strain, cycles));
  trials.push_back(trial(GLISSON_TEXT("Deform a fifth further."), 1.2 * seconds, std::max(-0.9, 1.2 * strain), ramp));
  trials.push_back(trial(GLISSON_TEXT("Deform to the other side (tension in place of compression, or the reverse)."),
                         seconds, std::max(-0.8, -0.5 * strain), ramp));
  return trials;
}

Observations observations_of(const Material& material) {
  Observations all;
  all.unit = "kPa";
  all.directions = {"stress"};
  std::vector<Observation> rows;
  for (const MaterialTrial& trial : material.trials) {
    for (Eigen::Index i = 0; i < trial.time_s.size(); ++i) {
      // The rate tells loading from unloading and fast from slow.
      const Eigen::Index before = std::max<Eigen::Index>(0, i - 1);
      const double passed_s = trial.time_s[i] - trial.time_s[before];
      const double rate = passed_s > 0 ? (trial.stretch[i] - trial.stretch[before]) / passed_s : 0;
      const bool measured = trial.stress_kPa.size() > 0;
      rows.push_back({.measured = measured ? trial.stress_kPa[i] : std::numeric_limits<double>::quiet_NaN(),
                      .noise = material.noise_kPa,
                      .trial = all.trial_count(),
                      .sample = static_cast<int>(i),
                      .point = static_cast<int>(rows.size()),
                      .time_s = trial.time_s[i],
                      .load = trial.stretch[i] - 1,
                      .conditions = {rate}});
    }
    all.trials.push_back(trial.id);
  }
  all.add(rows);
  return all;
}

}  // namespace
}  // namespace glisson::closedloop
