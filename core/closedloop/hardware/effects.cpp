#include "closedloop/hardware/effects.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace glisson::closedloop {
namespace {

// What was recorded, and how far it went.
struct HardwareReach {
  bool current = false;
  bool load = false;
  bool power = false;  // judged
  bool temperature = false;
  double largest_A = 0;
  double largest_W = 0;
  double hottest_C = 0;
  double longest_s = 1;
};

HardwareReach reach_of(const Hardware& hardware);

using HardwareEffects = std::vector<HardwareEffect>;
HardwareEffects effects_within(const Hardware& hardware, const HardwareReach& reach);
void add_battery(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects);
void add_power(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects);
void add_heat(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects);

}  // namespace

std::vector<HardwareEffect> hardware_effects(const Hardware& hardware) {
  return effects_within(hardware, reach_of(hardware));
}

std::vector<HardwareEffect> known_hardware_effects(const Hardware& hardware) {
  HardwareReach reach = reach_of(hardware);
  reach.current = reach.load = reach.power = reach.temperature = true;
  return effects_within(hardware, reach);
}

namespace {

HardwareEffects effects_within(const Hardware& hardware, const HardwareReach& reach) {
  HardwareEffects effects;
  if (hardware.nominal_voltage_V && reach.current) add_battery(hardware, reach, effects);
  if (reach.current || reach.load || reach.power) add_power(hardware, reach, effects);
  if (hardware.thermal_resistance_C_per_W) add_heat(hardware, reach, effects);
  return effects;
}

HardwareReach reach_of(const Hardware& hardware) {
  HardwareReach reach;
  const auto largest = [](const Eigen::VectorXd& values, double so_far) {
    return values.size() > 0 ? std::max(so_far, values.maxCoeff()) : so_far;
  };
  for (const HardwareTrial& trial : hardware.trials) {
    reach.current = reach.current || trial.current_A.size() > 0;
    reach.load = reach.load || trial.load.size() > 0;
    reach.power = reach.power || (hardware.noise_W && trial.power_W.size() > 0);
    reach.temperature = reach.temperature || trial.temperature_C.size() > 0;
    reach.largest_A = largest(trial.current_A, reach.largest_A);
    reach.largest_W = largest(trial.power_W, reach.largest_W);
    if (trial.current_A.size() > 0 && hardware.nominal_voltage_V)
      reach.largest_W = std::max(reach.largest_W, *hardware.nominal_voltage_V * reach.largest_A);
    reach.hottest_C = largest(trial.temperature_C, std::max(reach.hottest_C, trial.ambient_C));
    if (trial.time_s.size() > 1)
      reach.longest_s = std::max(reach.longest_s, trial.time_s[trial.time_s.size() - 1] - trial.time_s[0]);
  }
  reach.largest_A = std::max(reach.largest_A, 1e-3);
  reach.largest_W = std::max({reach.largest_W, hardware.idle_W + hardware.full_load_W.value_or(0), 1e-3});
  return reach;
}

void add_battery(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects) {
  const double nominal_V = *hardware.nominal_voltage_V;
  const double half_ohm = 0.5 * nominal_V / reach.largest_A;  // where half of the voltage would be lost
  effects.push_back(
      {{"internal-resistance",
        "",
        {{"resistance_ohm", 0, 0, 4 * half_ohm, 0, half_ohm}},
        GLISSON_TEXT("The battery's voltage falls under load: its own resistance turns energy into heat."),
        {numbers_of({0.02 * half_ohm})}},
       [](const auto& p, auto& behaviour) { behaviour.resistance_ohm = p[0]; }});
  if (hardware.thermal_resistance_C_per_W && reach.temperature)
    effects.push_back(
        {{"internal-resistance",
          "heating",
          {{"resistance_ohm", 0, 0, 4 * half_ohm, 0, half_ohm}},
          GLISSON_TEXT("The battery's voltage falls under load, and what is lost there is what warms it."),
          {numbers_of({0.02 * half_ohm}), numbers_of({0.2 * half_ohm})}},
         [](const auto& p, auto& behaviour) {
           behaviour.resistance_ohm = p[0];
           behaviour.heats_by_loss = true;
         }});
  if (hardware.capacity_Ah) {
    // The end of a discharge jumps with the exponent, so the search begins from many.
    std::vector<Eigen::VectorXd> starts;
    for (double exponent = 1.005; exponent < 1.5; exponent += 0.001) starts.push_back(numbers_of({exponent}));
    for (const auto& [form, hours] : {std::pair("", 5.0), std::pair("rated-1h", 1.0), std::pair("rated-20h", 20.0)}) {
      effects.push_back({{"rate-capacity",
                          form,
                          {{"exponent", 1, 1, 2, 1, 1.4}},
                          GLISSON_TEXT("The faster the battery is emptied, the less it gives (Peukert)."),
                          starts},
                         [hours = hours](const auto& p, auto& behaviour) {
                           behaviour.rate_exponent = p[0];
                           behaviour.rated_hours = hours;
                         }});
    }
    if (reach.temperature)
      effects.push_back({{"self-heating",
                          "capacity",
                          {{"coefficient_per_C", 0, -0.02, 0.05, -0.005, 0.02}},
                          GLISSON_TEXT("The battery gives less when it is cold and more when it is warm."),
                          {numbers_of({-0.005}), numbers_of({0.005}), numbers_of({0.01}), numbers_of({0.02})}},
                         [](const auto& p, auto& behaviour) { behaviour.capacity_per_C = p[0]; }});
  }
  for (const int degree : {1, 3, 5}) {
    Effect effect{"discharge-curve",
                  degree == 1 ? "" : "degree-" + std::to_string(degree),
                  {},
                  GLISSON_TEXT("The battery's voltage falls while it empties, which a constant voltage leaves out."),
                  {Eigen::VectorXd::Zero(degree + 1)}};
    for (int i = 0; i <= degree; ++i)
      effect.parameters.push_back({"curve_V", 0, -30 * nominal_V, 30 * nominal_V, -0.5 * nominal_V, 0.5 * nominal_V});
    effects.push_back({std::move(effect), [](const auto& p, auto& behaviour) { behaviour.discharge_curve_V = p; }});
  }
}

void add_power(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects) {
  effects.push_back({{"static-power",
                      "",
                      {{"static_W", 0, -reach.largest_W, 5 * reach.largest_W, 0, reach.largest_W}},
                      GLISSON_TEXT("The computer draws power whatever it does, more than was declared."),
                      {numbers_of({0.0})}},
                     [](const auto& p, auto& behaviour) { behaviour.static_W = p[0]; }});
  effects.push_back({{"supply-loss",
                      "",
                      {{"efficiency", 1, 0.2, 1.5, 0.6, 1, Scale::logarithmic}},
                      GLISSON_TEXT("A part of the power is lost in the supply before it reaches the computer."),
                      {numbers_of({0.98})}},
                     [](const auto& p, auto& behaviour) { behaviour.efficiency = p[0]; }});
  if (reach.temperature || hardware.thermal_resistance_C_per_W)
    effects.push_back({{"self-heating",
                        "",
                        {{"coefficient_per_C", 0, -0.02, 0.1, 0, 0.03}},
                        GLISSON_TEXT("The warmer the computer gets, the more power it draws."),
                        {numbers_of({0.001})}},
                       [](const auto& p, auto& behaviour) { behaviour.power_per_C = p[0]; }});
  if (reach.load && !hardware.full_load_W)
    effects.push_back({{"dynamic-power",
                        "",
                        {{"full_load_W", 0, 0, 1e3, 0, reach.largest_W}},
                        GLISSON_TEXT("The work itself takes power that was not declared."),
                        {numbers_of({0.1 * reach.largest_W})}},
                       [](const auto& p, auto& behaviour) { behaviour.full_load_W = p[0]; }});
}

void add_heat(const Hardware& hardware, const HardwareReach& reach, HardwareEffects& effects) {
  // Where it begins to act there is no gradient below, so that the search begins from many limits.
  std::vector<Eigen::VectorXd> starts;
  const double hottest = std::max(reach.hottest_C, 30.0);
  for (double share = 0.3; share < 1.05; share += 0.05) starts.push_back(numbers_of({25 + share * (hottest - 25)}));
  effects.push_back({{"thermal-throttling",
                      "",
                      {{"limit_C", 200, 0, 200, 40, 100}},
                      GLISSON_TEXT("The computer slows itself down to stay below a temperature."),
                      starts},
                     [](const auto& p, auto& behaviour) { behaviour.limit_C = p[0]; }});
  if (reach.load) {
    std::vector<Eigen::VectorXd> in_steps;
    for (double share = 0.4; share < 1.0; share += 0.05) {
      for (const double slower : {0.003, 0.01, 0.04}) {
        for (const double faster : {0.003, 0.01})
          in_steps.push_back(numbers_of({25 + share * (hottest - 25), slower, faster}));
      }
    }
    effects.push_back({{"thermal-throttling",
                        "steps",
                        {{"limit_C", 200, 0, 200, 40, 100},
                         {"slower_per_s", 0.01, 1e-4, 1, 2e-3, 0.1, Scale::logarithmic},
                         {"faster_per_s", 0.01, 1e-4, 1, 2e-3, 0.1, Scale::logarithmic}},
                        GLISSON_TEXT("The computer slows itself down to stay below a temperature."),
                        in_steps},
                       [](const auto& p, auto& behaviour) {
                         behaviour.limit_C = p[0];
                         behaviour.slower_per_s = p[1];
                         behaviour.faster_per_s = p[2];
                       }});
  }
  const double declared = *hardware.thermal_resistance_C_per_W;
  effects.push_back({{"thermal-resistance",
                      "",
                      {{"resistance_C_per_W", declared, declared / 50, declared * 20, declared / 2, declared * 2,
                        Scale::logarithmic}},
                      GLISSON_TEXT("Heat leaves the computer better or worse than declared."),
                      {numbers_of({declared})}},
                     [](const auto& p, auto& behaviour) { behaviour.thermal_resistance_C_per_W = p[0]; }});
  std::vector<Eigen::VectorXd> times;
  for (const double share : {0.03, 0.1, 0.3, 1.0}) times.push_back(numbers_of({share * reach.longest_s}));
  effects.push_back({{"thermal-inertia",
                      "",
                      {{"time_constant_s", reach.longest_s, 1e-3 * reach.longest_s, 20 * reach.longest_s,
                        0.01 * reach.longest_s, 2 * reach.longest_s, Scale::logarithmic}},
                      GLISSON_TEXT("The computer takes time to warm up, longer or shorter than declared."),
                      times},
                     [](const auto& p, auto& behaviour) { behaviour.time_constant_s = p[0]; }});
}

}  // namespace
}  // namespace glisson::closedloop
