#include "closedloop/hardware/behaviour.h"

#include <algorithm>
#include <cmath>

namespace glisson::closedloop {
namespace {

constexpr double seconds_in_hour = 3600;
constexpr double reference_C = 25;

double curve_V(const HardwareBehaviour& behaviour, double depth) {
  double sum = 0;
  for (Eigen::Index i = behaviour.discharge_curve_V.size(); i-- > 0;)
    sum = sum * depth + behaviour.discharge_curve_V[i];
  return sum;
}

// Depth of discharge at each time, 1 when nothing more can be had: charge counts more the faster it is drawn.
Eigen::VectorXd depth_of_discharge(const HardwareBehaviour& behaviour, const HardwareTrial& trial) {
  Eigen::VectorXd depth = Eigen::VectorXd::Zero(trial.time_s.size());
  if (behaviour.capacity_Ah <= 0 || trial.current_A.size() == 0) return depth;
  const double rated_A = behaviour.capacity_Ah / behaviour.rated_hours;
  for (Eigen::Index i = 1; i < depth.size(); ++i) {
    const double current = (trial.current_A[i] + trial.current_A[i - 1]) / 2;
    const double hours = (trial.time_s[i] - trial.time_s[i - 1]) / seconds_in_hour;
    const double rate = current > 0 ? std::pow(current / rated_A, behaviour.rate_exponent - 1) : 1;
    double capacity_Ah = behaviour.capacity_Ah;
    if (trial.temperature_C.size() > 0)
      capacity_Ah *= std::max(0.05, 1 + behaviour.capacity_per_C * (trial.temperature_C[i] - reference_C));
    depth[i] = depth[i - 1] + current * rate * hours / capacity_Ah;
  }
  return depth;
}

// 1 until the battery is empty, 0 after; the sample at which it empties has its share, so that the exponent can be
// found between samples.
double share_left(const Eigen::VectorXd& depth, Eigen::Index i) {
  if (depth[i] <= 1 || i == 0) return 1;
  if (depth[i - 1] >= 1) return 0;
  return (1 - depth[i - 1]) / (depth[i] - depth[i - 1]);
}

Eigen::VectorXd voltage_V(const HardwareBehaviour& behaviour, const HardwareTrial& trial) {
  if (behaviour.nominal_voltage_V <= 0) return {};
  const Eigen::VectorXd depth = depth_of_discharge(behaviour, trial);
  Eigen::VectorXd voltage(depth.size());
  for (Eigen::Index i = 0; i < depth.size(); ++i) {
    const double current = trial.current_A.size() > 0 ? trial.current_A[i] : 0;
    voltage[i] = share_left(depth, i) *
                 (behaviour.nominal_voltage_V + curve_V(behaviour, depth[i]) - current * behaviour.resistance_ohm);
  }
  return voltage;
}

// What the work asks for before anything is lost or saved.
Eigen::VectorXd demand_W(const HardwareBehaviour& behaviour, const HardwareTrial& trial,
                         const Eigen::VectorXd& voltage) {
  const Eigen::Index size = trial.time_s.size();
  if (trial.load.size() > 0) return behaviour.idle_W + behaviour.full_load_W * trial.load.array();
  if (trial.current_A.size() == 0) return Eigen::VectorXd::Constant(size, behaviour.idle_W);
  const Eigen::VectorXd& across = voltage.size() > 0 ? voltage : trial.voltage_V;
  if (across.size() == 0) return {};
  return behaviour.idle_W + across.array() * trial.current_A.array();
}

}  // namespace

HardwareBehaviour declared_behaviour(const Hardware& hardware) {
  HardwareBehaviour behaviour;
  behaviour.idle_W = hardware.idle_W;
  behaviour.full_load_W = hardware.full_load_W.value_or(0);
  behaviour.nominal_voltage_V = hardware.nominal_voltage_V.value_or(0);
  behaviour.capacity_Ah = hardware.capacity_Ah.value_or(0);
  behaviour.thermal_resistance_C_per_W = hardware.thermal_resistance_C_per_W.value_or(0);
  behaviour.time_constant_s = hardware.time_constant_s.value_or(0);
  return behaviour;
}

namespace {

// A recording that begins in a room's temperature begins there, whatever the first reading's noise.
double first_temperature_C(const Hardware& hardware, const HardwareTrial& trial) {
  constexpr double clearly = 4;
  if (trial.temperature_C.size() == 0) return trial.ambient_C;
  const double first = trial.temperature_C[0];
  return std::abs(first - trial.ambient_C) < clearly * hardware.noise_C.value_or(0) ? trial.ambient_C : first;
}

double between_samples(const Eigen::VectorXd& heating, Eigen::Index i, double now, Hold hold) {
  switch (hold) {
    case Hold::sample_before: return heating[i - 1];
    case Hold::sample_after: return now;
    default: return (heating[i - 1] + now) / 2;
  }
}

// The computer slowed down in steps: its speed and the temperature that drives it, from sample to sample.
class Governor {
 public:
  Governor(const HardwareBehaviour& behaviour, const HardwareTrial& trial, double temperature_C, Hold hold)
      : behaviour_(behaviour), trial_(trial), hold_(hold), temperature_C_(temperature_C) {}

  [[nodiscard]] double speed() const { return speed_; }

  void go_on_to(Eigen::Index sample) {
    constexpr double longest_step_s = 1, minimum_speed = 0.05;
    const double passed_s = trial_.time_s[sample] - trial_.time_s[sample - 1];
    const int steps = std::clamp(static_cast<int>(std::ceil(passed_s / longest_step_s)), 1, 600);
    const double step_s = passed_s / steps;
    const double load = between_samples(trial_.load, sample, trial_.load[sample], hold_);
    const double share = behaviour_.time_constant_s > 0 ? -std::expm1(-step_s / behaviour_.time_constant_s) : 1.0;
    for (int step = 0; step < steps; ++step) {
      const double power_W = (behaviour_.idle_W + behaviour_.full_load_W * load * speed_ + behaviour_.static_W) *
                             (1 + behaviour_.power_per_C * (temperature_C_ - trial_.ambient_C)) / behaviour_.efficiency;
      const double steady_C = trial_.ambient_C + behaviour_.thermal_resistance_C_per_W * power_W;
      const double next_C = temperature_C_ + share * (steady_C - temperature_C_);
      // The share of the step spent above the limit: what is predicted changes smoothly with it.
      const double hottest = std::max(temperature_C_, next_C), coolest = std::min(temperature_C_, next_C);
      const double above = hottest > coolest
                               ? std::clamp((hottest - *behaviour_.limit_C) / (hottest - coolest), 0.0, 1.0)
                               : double(hottest >= *behaviour_.limit_C);
      speed_ += step_s * ((1 - above) * behaviour_.faster_per_s - above * behaviour_.slower_per_s);
      speed_ = std::clamp(speed_, minimum_speed, 1.0);
      temperature_C_ = next_C;
    }
  }

 private:
  const HardwareBehaviour& behaviour_;
  const HardwareTrial& trial_;
  Hold hold_;
  double temperature_C_;
  double speed_ = 1;
};

}  // namespace

HardwareReadings readings(const HardwareBehaviour& behaviour, const Hardware& hardware, const HardwareTrial& trial,
                          Hold hold) {
  HardwareReadings all;
  all.voltage_V = voltage_V(behaviour, trial);
  const Eigen::VectorXd demand = demand_W(behaviour, trial, all.voltage_V);
  const bool heats = hardware.thermal_resistance_C_per_W.has_value();
  const double to_air = behaviour.thermal_resistance_C_per_W;
  const Eigen::Index size = trial.time_s.size();
  if (demand.size() > 0) all.power_W.resize(size);
  const bool power_known = demand.size() > 0 || trial.power_W.size() > 0;
  if (heats && power_known) all.temperature_C.resize(size);
  double temperature = first_temperature_C(hardware, trial);
  Eigen::VectorXd heating(size);
  const bool in_steps = behaviour.limit_C && behaviour.slower_per_s > 0 && trial.load.size() > 0;
  Governor governor(behaviour, trial, temperature, hold);
  for (Eigen::Index i = 0; i < size; ++i) {
    double power = 0;
    if (demand.size() > 0) {
      const double hot = trial.temperature_C.size() > 0 ? trial.temperature_C[i] : temperature;
      if (in_steps && i > 0) governor.go_on_to(i);
      const double asked_W =
          in_steps ? demand[i] - behaviour.full_load_W * trial.load[i] * (1 - governor.speed()) : demand[i];
      power =
          (asked_W + behaviour.static_W) * (1 + behaviour.power_per_C * (hot - trial.ambient_C)) / behaviour.efficiency;
    }
    if (heats) {
      heating[i] = demand.size() == 0 && trial.power_W.size() > 0 ? trial.power_W[i] : power;
      if (behaviour.heats_by_loss && trial.current_A.size() > 0)
        heating[i] = trial.current_A[i] * trial.current_A[i] * behaviour.resistance_ohm;
      if (behaviour.time_constant_s <= 0) {
        temperature = trial.ambient_C + to_air * heating[i];
      } else if (i > 0) {
        const double steady = trial.ambient_C + to_air * between_samples(heating, i, heating[i], hold);
        const double passed_s = trial.time_s[i] - trial.time_s[i - 1];
        temperature = steady + (temperature - steady) * std::exp(-passed_s / behaviour.time_constant_s);
      }
      if (behaviour.limit_C && !in_steps && temperature > *behaviour.limit_C) {
        temperature = std::max(*behaviour.limit_C, trial.ambient_C);
        power = std::min(power, (temperature - trial.ambient_C) / to_air);
        heating[i] = std::min(heating[i], power);
      }
    }
    if (all.power_W.size() > 0) all.power_W[i] = power;
    if (all.temperature_C.size() > 0) all.temperature_C[i] = temperature;
  }
  return all;
}

Eigen::VectorXd charge_drawn_Ah(const HardwareTrial& trial) {
  Eigen::VectorXd charge = Eigen::VectorXd::Zero(trial.time_s.size());
  if (trial.current_A.size() == 0) return charge;
  for (Eigen::Index i = 1; i < charge.size(); ++i)
    charge[i] = charge[i - 1] + (trial.current_A[i] + trial.current_A[i - 1]) / 2 *
                                    (trial.time_s[i] - trial.time_s[i - 1]) / seconds_in_hour;
  return charge;
}

}  // namespace glisson::closedloop
