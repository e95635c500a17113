#include "closedloop/hardware/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/json.h"
#include "closedloop/hardware/effects.h"

namespace glisson::closedloop {
namespace {

// The three quantities, by the numbers of Observations::direction.
constexpr std::size_t quantities = 3;
const std::vector<std::string> names{"voltage_V", "temperature_C", "power_W"};

class HardwareModel : public ForwardModel {
 public:
  explicit HardwareModel(Hardware hardware);

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override;
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override;
  [[nodiscard]] std::vector<FurtherTrial> further_trials() const override;
  [[nodiscard]] Result<Eigen::VectorXd> predict_further(const Settings& settings) const override;

 private:
  struct FurtherRecording {
    Sentence sentence;
    HardwareTrial trial;
  };
  [[nodiscard]] std::vector<FurtherRecording> further() const;
  [[nodiscard]] Eigen::VectorXd in_noises(HardwareReadings predicted) const;
  [[nodiscard]] Eigen::VectorXd predicted_by(const HardwareBehaviour& behaviour, Hold hold) const;
  [[nodiscard]] Result<HardwareBehaviour> behaviour(const Settings& settings) const;
  [[nodiscard]] bool is_compared(const HardwareTrial& trial, std::size_t quantity) const;
  void observe(const HardwareTrial& trial);
  void blur_the_end(const HardwareTrial& trial, const std::vector<std::size_t>& seen, Eigen::Index first);

  Hardware hardware_;
  std::vector<HardwareEffect> effects_;  // also those that these trials could not show
  std::vector<Effect> catalogue_;
  Observations observations_;
};

std::array<Eigen::VectorXd, quantities> in_order(HardwareReadings readings) {
  return {std::move(readings.voltage_V), std::move(readings.temperature_C), std::move(readings.power_W)};
}

const Eigen::VectorXd& measured(const HardwareTrial& trial, std::size_t quantity) {
  return quantity == 0 ? trial.voltage_V : quantity == 1 ? trial.temperature_C : trial.power_W;
}

}  // namespace

Result<std::unique_ptr<ForwardModel>> hardware_model(Hardware hardware) {
  auto model = std::make_unique<HardwareModel>(std::move(hardware));
  if (model->observations().rows() == 0)
    return failure(
        Error{"experiment-invalid",
              GLISSON_TEXT("The declared figures predict none of the recorded quantities."),
              {},
              GLISSON_TEXT("Voltage needs nominal_voltage_V, temperature needs thermal_resistance_C_per_W and "
                           "a power, power needs a current or a load."),
              {}});
  return model;
}

namespace {

HardwareModel::HardwareModel(Hardware hardware)
    : hardware_(std::move(hardware)), effects_(known_hardware_effects(hardware_)) {
  for (HardwareEffect& effect : hardware_effects(hardware_)) catalogue_.push_back(std::move(effect.effect));
  observations_.unit = "noise";
  observations_.directions = names;
  for (const HardwareTrial& trial : hardware_.trials) observe(trial);
}

// A quantity is compared where it was recorded, its noise is known and the declared model predicts it.
bool HardwareModel::is_compared(const HardwareTrial& trial, std::size_t quantity) const {
  const std::array noises{hardware_.noise_V, hardware_.noise_C, hardware_.noise_W};
  if (!noises[quantity] || measured(trial, quantity).size() == 0) return false;
  return in_order(readings(declared_behaviour(hardware_), hardware_, trial))[quantity].size() > 0;
}

void HardwareModel::observe(const HardwareTrial& trial) {
  Observations& all = observations_;
  const std::array noises{hardware_.noise_V, hardware_.noise_C, hardware_.noise_W};
  std::vector<std::size_t> seen;
  for (std::size_t quantity = 0; quantity < quantities; ++quantity) {
    if (is_compared(trial, quantity)) seen.push_back(quantity);
  }
  const Eigen::VectorXd charge = charge_drawn_Ah(trial);
  const Eigen::VectorXd& load = trial.current_A.size() > 0 ? trial.current_A
                                : trial.load.size() > 0    ? trial.load
                                                           : trial.power_W;
  const Eigen::Index first = all.rows();
  std::vector<Observation> rows;
  for (Eigen::Index i = 0; i < trial.time_s.size(); ++i) {
    for (const std::size_t quantity : seen) {
      const double time_s = trial.time_s[i] - trial.time_s[0];
      rows.push_back({.measured = measured(trial, quantity)[i],
                      .noise = *noises[quantity],
                      .trial = all.trial_count(),
                      .sample = static_cast<int>(i),
                      .direction = static_cast<int>(quantity),
                      .point = static_cast<int>(first) + static_cast<int>(rows.size()),
                      .time_s = time_s,
                      .load = load.size() > 0 ? load[i] : 0,
                      .conditions = {charge[i], std::log1p(time_s)}});
    }
  }
  all.add(rows);
  blur_the_end(trial, seen, first);
  all.trials.push_back(trial.id);
}

// When a battery gives up is known to a sample: the readings beside the jump are as uncertain as the jump is high.
void HardwareModel::blur_the_end(const HardwareTrial& trial, const std::vector<std::size_t>& seen, Eigen::Index first) {
  if (!hardware_.nominal_voltage_V || trial.voltage_V.size() == 0) return;
  const auto columns = static_cast<Eigen::Index>(seen.size());
  const Eigen::Index last = trial.time_s.size() - 1;
  for (Eigen::Index i = 1; i <= last; ++i) {
    if (std::abs(trial.voltage_V[i] - trial.voltage_V[i - 1]) < 0.25 * *hardware_.nominal_voltage_V) continue;
    for (Eigen::Index beside = i - 1; beside <= std::min(i + 1, last); ++beside) {
      for (Eigen::Index column = 0; column < columns; ++column) {
        const Eigen::VectorXd& readings_of = measured(trial, seen[static_cast<std::size_t>(column)]);
        double& noise = observations_.noise[first + beside * columns + column];
        if (seen[static_cast<std::size_t>(column)] != 1)
          noise = std::max(noise, std::abs(readings_of[i] - readings_of[i - 1]));
      }
    }
  }
}

Result<HardwareBehaviour> HardwareModel::behaviour(const Settings& settings) const {
  HardwareBehaviour behaviour = declared_behaviour(hardware_);
  for (const Setting& setting : settings) {
    const auto found = std::find_if(effects_.begin(), effects_.end(), [&](const HardwareEffect& effect) {
      return effect.effect.kind == setting.kind && effect.effect.form == setting.form;
    });
    GLISSON_ASSERT(found != effects_.end());
    found->apply(setting.parameters, behaviour);
  }
  return behaviour;
}

Result<Eigen::VectorXd> HardwareModel::predict(const Settings& settings) const {
  const auto changed = behaviour(settings);
  if (!changed) return failure(changed.error());
  Eigen::VectorXd predicted = predicted_by(*changed, Hold::mean_of_both);
  if (!predicted.allFinite())
    return failure("platform-out-of-range", GLISSON_TEXT("The model of the platform has no finite answer here."));
  return predicted;
}

Eigen::VectorXd HardwareModel::predicted_by(const HardwareBehaviour& behaviour, Hold hold) const {
  Eigen::VectorXd predicted(observations_.rows());
  Eigen::Index row = 0;
  for (std::size_t t = 0; t < hardware_.trials.size(); ++t) {
    const auto values = in_order(readings(behaviour, hardware_, hardware_.trials[t], hold));
    for (; row < predicted.size() && observations_.trial[static_cast<std::size_t>(row)] == static_cast<int>(t); ++row) {
      const auto i = static_cast<std::size_t>(row);
      predicted[row] = values[static_cast<std::size_t>(observations_.direction[i])][observations_.sample[i]];
    }
  }
  return predicted;
}

// What power was between two samples nobody recorded: half of the difference that it can make, in each trial its own,
// for one may go in steps and another in waves.
SystematicUncertainty HardwareModel::systematic_uncertainty() const {
  const HardwareBehaviour declared = declared_behaviour(hardware_);
  const Eigen::VectorXd half =
      (predicted_by(declared, Hold::sample_after) - predicted_by(declared, Hold::sample_before)) / 2;
  SystematicUncertainty uncertainty;
  uncertainty.directions = Eigen::MatrixXd::Zero(half.size(), observations_.trial_count());
  for (Eigen::Index row = 0; row < half.size(); ++row)
    uncertainty.directions(row, observations_.trial[static_cast<std::size_t>(row)]) = half[row];
  return uncertainty;
}

std::vector<FurtherTrial> HardwareModel::further_trials() const {
  std::vector<FurtherTrial> trials;
  for (FurtherRecording& further : further()) {
    const HardwareTrial& trial = further.trial;
    Json conditions{{"id", trial.id}, {"ambient_C", trial.ambient_C}};
    const auto column = [&](const char* name, const Eigen::VectorXd& values) {
      if (values.size() > 0) conditions[name] = std::vector<double>(values.begin(), values.end());
    };
    column("time_s", trial.time_s);
    column("current_A", trial.current_A);
    column("load", trial.load);
    const Eigen::Index rows = in_noises(readings(declared_behaviour(hardware_), hardware_, trial)).size();
    trials.push_back({std::move(further.sentence), std::make_shared<const Json>(std::move(conditions)), rows});
  }
  return trials;
}

Result<Eigen::VectorXd> HardwareModel::predict_further(const Settings& settings) const {
  const auto changed = behaviour(settings);
  if (!changed) return failure(changed.error());
  Eigen::VectorXd all;
  for (const FurtherRecording& further : further()) {
    const Eigen::VectorXd own = in_noises(readings(*changed, hardware_, further.trial));
    const Eigen::Index before = all.size();
    all.conservativeResize(before + own.size());
    all.tail(own.size()) = own;
  }
  return all;
}

// Variations of the longest trial.
std::vector<HardwareModel::FurtherRecording> HardwareModel::further() const {
  HardwareTrial trial =
      *std::max_element(hardware_.trials.begin(), hardware_.trials.end(),
                        [](const auto& a, const auto& b) { return a.time_s.size() < b.time_s.size(); });
  // Nothing is measured there yet.
  trial.voltage_V.resize(0);
  trial.temperature_C.resize(0);
  trial.power_W.resize(0);
  std::vector<FurtherRecording> all;
  const auto add = [&](const char* sentence, double times, double warmer_C) {
    HardwareTrial changed = trial;
    changed.id = "next-" + std::to_string(all.size() + 1);
    changed.current_A *= times;
    changed.load *= times;
    changed.ambient_C += warmer_C;
    all.push_back({{sentence, {}}, std::move(changed)});
  };
  add(GLISSON_TEXT("Repeat the longest trial at half of its current or load."), 0.5, 0);
  add(GLISSON_TEXT("Repeat the longest trial at twice its current or load."), 2, 0);
  add(GLISSON_TEXT("Repeat the longest trial in a room that is 15 °C warmer."), 1, 15);
  return all;
}

Eigen::VectorXd HardwareModel::in_noises(HardwareReadings predicted) const {
  const auto values = in_order(std::move(predicted));
  const std::array noises{hardware_.noise_V, hardware_.noise_C, hardware_.noise_W};
  Eigen::VectorXd all;
  for (std::size_t quantity = 0; quantity < quantities; ++quantity) {
    if (!noises[quantity] || values[quantity].size() == 0) continue;
    const Eigen::Index before = all.size();
    all.conservativeResize(before + values[quantity].size());
    all.tail(values[quantity].size()) = values[quantity] / *noises[quantity];
  }
  return all;
}

}  // namespace
}  // namespace glisson::closedloop
