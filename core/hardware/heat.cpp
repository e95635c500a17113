#include "hardware/heat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::hardware {

double steady_temperature_C(const HeatModel& model, double power_W, double ambient_C) {
  return ambient_C + model.resistance_C_per_W * power_W;
}

double temperature_after_C(const HeatModel& model, double start_C, double power_W, double ambient_C, double elapsed_s) {
  const double steady_C = steady_temperature_C(model, power_W, ambient_C);
  return steady_C + (start_C - steady_C) * std::exp(-elapsed_s / model.time_constant_s);
}

double time_to_reach_s(const HeatModel& model, double start_C, double power_W, double ambient_C, double limit_C) {
  if (start_C >= limit_C) return 0;
  const double steady_C = steady_temperature_C(model, power_W, ambient_C);
  if (steady_C <= limit_C) return std::numeric_limits<double>::infinity();
  return model.time_constant_s * std::log((steady_C - start_C) / (steady_C - limit_C));
}

double largest_power_W(const HeatModel& model, double ambient_C, double limit_C, double elapsed_s) {
  const double reached = -std::expm1(-elapsed_s / model.time_constant_s);
  return std::max(0.0, limit_C - ambient_C) / (model.resistance_C_per_W * reached);
}

}  // namespace glisson::hardware
