#include "closedloop/platform_behaviour.h"

#include <algorithm>
#include <cmath>

namespace glisson::closedloop {
namespace {

constexpr double seconds_in_hour = 3600;
constexpr double reference_C = 25;

double curve_V(const PlatformBehaviour& behaviour, double depth) {
  double sum = 0;
  for (Eigen::Index i = behaviour.discharge_curve_V.size(); i-- > 0;)
    sum = sum * depth + behaviour.discharge_curve_V[i];
  return sum;
}

// Depth of discharge at each time, 1 when nothing more can be had: charge counts more the faster it is drawn.
Eigen::VectorXd depth_of_discharge(const PlatformBehaviour& behaviour, const PlatformTrial& trial) {
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

Eigen::VectorXd voltage_V(const PlatformBehaviour& behaviour, const PlatformTrial& trial) {
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
Eigen::VectorXd demand_W(const PlatformBehaviour& behaviour, const PlatformTrial& trial,
                         const Eigen::VectorXd& voltage) {
  const Eigen::Index size = trial.time_s.size();
  if (trial.load.size() > 0) return behaviour.idle_W + behaviour.full_load_W * trial.load.array();
  if (trial.current_A.size() == 0) return Eigen::VectorXd::Constant(size, behaviour.idle_W);
  const Eigen::VectorXd& across = voltage.size() > 0 ? voltage : trial.voltage_V;
  if (across.size() == 0) return {};
  return behaviour.idle_W + across.array() * trial.current_A.array();
}

}  // namespace

PlatformBehaviour declared_behaviour(const Platform& platform) {
  PlatformBehaviour behaviour;
  behaviour.idle_W = platform.idle_W;
  behaviour.full_load_W = platform.full_load_W.value_or(0);
  behaviour.nominal_voltage_V = platform.nominal_voltage_V.value_or(0);
  behaviour.capacity_Ah = platform.capacity_Ah.value_or(0);
  behaviour.thermal_resistance_C_per_W = platform.thermal_resistance_C_per_W.value_or(0);
  behaviour.time_constant_s = platform.time_constant_s.value_or(0);
  return behaviour;
}

namespace {

// A recording that begins in a room's temperature begins there, whatever the first reading's noise.
double first_temperature_C(const Platform& platform, const PlatformTrial& trial) {
  constexpr double clearly = 4;
  if (trial.temperature_C.size() == 0) return trial.ambient_C;
  const double first = trial.temperature_C[0];
  return std::abs(first - trial.ambient_C) < clearly * platform.noise_C.value_or(0) ? trial.ambient_C : first;
}

double between_samples(const Eigen::VectorXd& heating, Eigen::Index i, double now, Hold hold) {
  switch (hold) {
    case Hold::sample_before: return heating[i - 1];
    case Hold::sample_after: return now;
    default: return (heating[i - 1] + now) / 2;
  }
}

}  // namespace

PlatformReadings readings(const PlatformBehaviour& behaviour, const Platform& platform, const PlatformTrial& trial,
                          Hold hold) {
  PlatformReadings all;
  all.voltage_V = voltage_V(behaviour, trial);
  const Eigen::VectorXd demand = demand_W(behaviour, trial, all.voltage_V);
  const bool heats = platform.thermal_resistance_C_per_W.has_value();
  const double to_air = behaviour.thermal_resistance_C_per_W;
  const Eigen::Index size = trial.time_s.size();
  if (demand.size() > 0) all.power_W.resize(size);
  const bool power_known = demand.size() > 0 || trial.power_W.size() > 0;
  if (heats && power_known) all.temperature_C.resize(size);
  double temperature = first_temperature_C(platform, trial);
  Eigen::VectorXd heating(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    double power = 0;
    if (demand.size() > 0) {
      const double hot = trial.temperature_C.size() > 0 ? trial.temperature_C[i] : temperature;
      power = (demand[i] + behaviour.static_W) * (1 + behaviour.power_per_C * (hot - trial.ambient_C)) /
              behaviour.efficiency;
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
      if (behaviour.limit_C && temperature > *behaviour.limit_C) {
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

Eigen::VectorXd charge_drawn_Ah(const PlatformTrial& trial) {
  Eigen::VectorXd charge = Eigen::VectorXd::Zero(trial.time_s.size());
  if (trial.current_A.size() == 0) return charge;
  for (Eigen::Index i = 1; i < charge.size(); ++i)
    charge[i] = charge[i - 1] + (trial.current_A[i] + trial.current_A[i - 1]) / 2 *
                                    (trial.time_s[i] - trial.time_s[i - 1]) / seconds_in_hour;
  return charge;
}

}  // namespace glisson::closedloop
