#include "hardware/battery.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace glisson::hardware {
namespace {

// The current at which the terminals give the load: the smaller root of V I - R I^2 = P.
double current_for_load_A(const Battery& battery, double load_W) {
  const double voltage = battery.nominal_voltage_V;
  const double resistance = battery.internal_resistance_ohm;
  const double discriminant = voltage * voltage - 4 * resistance * load_W;
  return 2 * load_W / (voltage + std::sqrt(discriminant));
}

double deliverable_load_W(const Battery& battery) {
  if (battery.internal_resistance_ohm == 0) return HUGE_VAL;
  return battery.nominal_voltage_V * battery.nominal_voltage_V / (4 * battery.internal_resistance_ohm);
}

double usable_fraction(const Battery& battery, double current_A, double battery_C) {
  const double rated_A = battery.capacity_Ah / battery.rated_hours;
  const double by_rate = std::min(1.0, std::pow(rated_A / current_A, battery.rate_exponent - 1));
  const double by_temperature = std::clamp(1 + battery.capacity_per_C * (battery_C - 25), 0.0, 1.0);
  return by_rate * by_temperature;
}

}  // namespace

Result<void> check(const Battery& battery) {
  const auto refuse = [](const char* what, double value) {
    return failure(Error{"battery-invalid",
                         GLISSON_TEXT("A battery with a {0} of {1} does not exist."),
                         {what, fmt::format("{:g}", value)},
                         GLISSON_TEXT("Correct the device's battery."),
                         {}});
  };
  // Written so that NaN is refused as well.
  if (!(battery.capacity_Ah > 0 && battery.capacity_Ah <= 1000)) return refuse("capacity (Ah)", battery.capacity_Ah);
  if (!(battery.nominal_voltage_V > 0 && battery.nominal_voltage_V <= 1000))
    return refuse("voltage (V)", battery.nominal_voltage_V);
  if (!(battery.internal_resistance_ohm >= 0 && battery.internal_resistance_ohm <= 1000))
    return refuse("internal resistance (ohm)", battery.internal_resistance_ohm);
  if (!(battery.rate_exponent >= 1 && battery.rate_exponent <= 2))
    return refuse("rate exponent", battery.rate_exponent);
  if (!(battery.rated_hours > 0 && battery.rated_hours <= 1000)) return refuse("rated time (h)", battery.rated_hours);
  if (!(battery.capacity_per_C >= 0 && battery.capacity_per_C <= 0.1))
    return refuse("change of capacity with temperature (1/C)", battery.capacity_per_C);
  return {};
}

Result<Drain> drain(const Battery& battery, double load_W, double battery_C) {
  GLISSON_ASSERT(load_W > 0);
  if (load_W > deliverable_load_W(battery)) {
    return failure(Error{"battery-overloaded",
                         GLISSON_TEXT("A load of {0} W is more than the battery's internal resistance lets through."),
                         {fmt::format("{:.3g}", load_W)},
                         {},
                         {}});
  }
  const double current_A = current_for_load_A(battery, load_W);
  Drain drained;
  drained.current_A = current_A;
  drained.hours = battery.capacity_Ah * usable_fraction(battery, current_A, battery_C) / current_A;
  drained.stored_Wh = battery.energy_Wh();
  drained.delivered_Wh = load_W * drained.hours;
  drained.heat_Wh = current_A * current_A * battery.internal_resistance_ohm * drained.hours;
  drained.left_Wh = drained.stored_Wh - drained.delivered_Wh - drained.heat_Wh;
  return drained;
}

double largest_load_W(const Battery& battery, double hours, double battery_C) {
  // Never more than the ideal battery would carry, and drain() falls as the load grows.
  double low = 0;
  double high = std::min(battery.energy_Wh() / hours, deliverable_load_W(battery));
  const auto holds = [&](double load_W) {
    const auto drained = drain(battery, load_W, battery_C);
    return drained && drained->hours >= hours;
  };
  if (holds(high)) return high;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace glisson::hardware
