#include "hardware/device.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "hardware/internal/device_figures.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t maximum_measured_points = 10000;

ProductCost roofline_cost(const KernelModel& kernel, const Workload& workload);
ProductCost measured_cost(const KernelModel& kernel, const Workload& workload);
bool covers(const KernelModel& kernel, const Workload& workload);
Result<void> check_measured(const Device& device);

}  // namespace

Battery battery_of(const Device& device) {
  Battery battery;
  battery.capacity_Ah = device.battery.capacity_mAh.value * 1e-3;
  battery.nominal_voltage_V = device.battery.voltage_V.value;
  battery.internal_resistance_ohm = device.battery.internal_resistance_ohm.value;
  battery.rate_exponent = device.battery.rate_exponent.value;
  battery.capacity_per_C = device.battery.capacity_per_C.value;
  return battery;
}

HeatModel heat_of(const Device& device) {
  return {device.thermal_resistance_C_per_W.value, device.thermal_time_constant_s.value};
}

ProductCost product_cost(const Device& device, const Workload& workload) {
  return covers(device.kernel, workload) ? measured_cost(device.kernel, workload)
                                         : roofline_cost(device.kernel, workload);
}

double fastest_frames_per_s(const Device& device, const Workload& workload) {
  return 1.0 / (product_cost(device, workload).seconds * workload.products_per_frame);
}

double power_W(const Device& device, const Workload& workload, double frames_per_s) {
  const double computed = std::min(frames_per_s, fastest_frames_per_s(device, workload));
  return device.idle_W.value + product_cost(device, workload).joules * workload.products_per_frame * computed;
}

std::vector<NamedFigure> figures_of(const Device& device) {
  std::vector<NamedFigure> figures;
  for (const FigureSlot& slot : figure_slots()) figures.push_back({slot.full_name(), slot.of_const(device)});
  return figures;
}

std::vector<std::string> assumed_figures(const Device& device) {
  std::vector<std::string> names;
  for (const NamedFigure& named : figures_of(device)) {
    if (named.figure.source == Source::assumed) names.push_back(named.name);
  }
  return names;
}

std::string to_string(Worn worn) {
  switch (worn) {
    case Worn::head: return "head";
    case Worn::belt: return "belt";
    case Worn::back: return "back";
  }
  return "back";
}

const std::vector<FigureSlot>& figure_slots() {
  // Limits are those of anything that a person could wear; they catch a wrong unit or a slipped sign.
  static const std::vector<FigureSlot> slots{
      {"", "idle_W", [](Device& d) -> Figure& { return d.idle_W; }, 1e-3, 1000, {}},
      {"", "supply_efficiency", [](Device& d) -> Figure& { return d.supply_efficiency; }, 0.1, 1, 1.0},
      {"",
       "thermal_resistance_C_per_W",
       [](Device& d) -> Figure& { return d.thermal_resistance_C_per_W; },
       1e-3,
       1000,
       {}},
      {"", "thermal_time_constant_s", [](Device& d) -> Figure& { return d.thermal_time_constant_s; }, 1, 1e5, {}},
      {"", "throttle_C", [](Device& d) -> Figure& { return d.throttle_C; }, 30, never_throttles_C, never_throttles_C},
      {"battery", "capacity_mAh", [](Device& d) -> Figure& { return d.battery.capacity_mAh; }, 1, 1e6, {}},
      {"battery", "voltage_V", [](Device& d) -> Figure& { return d.battery.voltage_V; }, 0.5, 100, {}},
      {"battery", "internal_resistance_ohm", [](Device& d) -> Figure& { return d.battery.internal_resistance_ohm; }, 0,
       10, 0.0},
      {"battery", "rate_exponent", [](Device& d) -> Figure& { return d.battery.rate_exponent; }, 1, 2, 1.0},
      {"battery", "capacity_per_C", [](Device& d) -> Figure& { return d.battery.capacity_per_C; }, 0, 0.1, 0.0},
      {"kernel", "bandwidth_GB_s", [](Device& d) -> Figure& { return d.kernel.bandwidth_GB_s; }, 1e-3, 1e5, {}},
      {"kernel", "peak_GFLOPS", [](Device& d) -> Figure& { return d.kernel.peak_GFLOPS; }, 1e-3, 1e7, {}},
      {"kernel", "fast_memory_MB", [](Device& d) -> Figure& { return d.kernel.fast_memory_MB; }, 0, 1e5, 0.0},
      {"kernel", "fast_bandwidth_GB_s", [](Device& d) -> Figure& { return d.kernel.fast_bandwidth_GB_s; }, 1e-3, 1e6,
       1.0},
      {"kernel", "launch_us", [](Device& d) -> Figure& { return d.kernel.launch_us; }, 0, 1e6, 0.0},
      {"kernel", "tile_nodes", [](Device& d) -> Figure& { return d.kernel.tile_nodes; }, 1, 1e7, 1.0},
      {"kernel", "active_W", [](Device& d) -> Figure& { return d.kernel.active_W; }, 0, 1000, {}},
      {"kernel", "energy_nJ_per_byte", [](Device& d) -> Figure& { return d.kernel.energy_nJ_per_byte; }, 0, 1000, {}},
  };
  return slots;
}

Result<void> check(const Device& device) {
  for (const FigureSlot& slot : figure_slots()) {
    const double value = slot.of_const(device).value;
    if (value >= slot.minimum && value <= slot.maximum) continue;
    return failure(Error{"device-invalid",
                         GLISSON_TEXT("Device {0} has {1} {2}; it must lie between {3} and {4}."),
                         {device.id, slot.full_name(), fmt::format("{:g}", value), fmt::format("{:g}", slot.minimum),
                          fmt::format("{:g}", slot.maximum)},
                         GLISSON_TEXT("Correct that figure in the device's file."),
                         {}});
  }
  return check_measured(device);
}

namespace {

// Measured points were taken with one size of blocks, and say nothing about another.
bool covers(const KernelModel& kernel, const Workload& workload) {
  return !kernel.measured.empty() && workload.block_columns == 3 * kernel.measured_nodes_in_domain;
}

ProductCost roofline_cost(const KernelModel& kernel, const Workload& workload) {
  const double tile = kernel.tile_nodes.value;
  const double padding = std::ceil(workload.nodes / tile) * tile / workload.nodes;
  const bool fits = workload.product_bytes <= kernel.fast_memory_MB.value * 1e6;
  const double bandwidth_GB_s = fits ? kernel.fast_bandwidth_GB_s.value : kernel.bandwidth_GB_s.value;
  ProductCost cost;
  cost.seconds =
      kernel.launch_us.value * 1e-6 + padding * std::max(workload.product_bytes / (bandwidth_GB_s * 1e9),
                                                         workload.product_flops / (kernel.peak_GFLOPS.value * 1e9));
  cost.joules = kernel.active_W.value * cost.seconds + kernel.energy_nJ_per_byte.value * 1e-9 * workload.product_bytes;
  return cost;
}

// y at x on the straight line through two points in log-log; proportional to x beyond the ends.
double interpolated(double x, double x0, double y0, double x1, double y1) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

ProductCost measured_cost(const KernelModel& kernel, const Workload& workload) {
  const auto& points = kernel.measured;
  const double nodes = workload.nodes;
  const auto joules_of = [&kernel](const MeasuredProduct& point) {
    return point.joules.value_or(kernel.active_W.value * point.seconds);
  };
  if (nodes <= points.front().nodes) return {points.front().seconds, joules_of(points.front())};
  if (nodes >= points.back().nodes) {
    const double factor = nodes / points.back().nodes;
    return {points.back().seconds * factor, joules_of(points.back()) * factor};
  }
  const auto above = std::find_if(points.begin(), points.end(), [&](auto& point) { return point.nodes > nodes; });
  const auto below = above - 1;
  return {interpolated(nodes, below->nodes, below->seconds, above->nodes, above->seconds),
          interpolated(nodes, below->nodes, joules_of(*below), above->nodes, joules_of(*above))};
}

Result<void> check_measured(const Device& device) {
  const auto& points = device.kernel.measured;
  bool sound = points.size() <= maximum_measured_points;
  for (std::size_t i = 0; i < points.size() && sound; ++i) {
    const MeasuredProduct& point = points[i];
    const double joules = point.joules.value_or(1);
    sound = point.nodes >= 1 && point.nodes <= 1e12 && point.seconds >= 1e-12 && point.seconds <= 1e6 &&
            joules >= 1e-15 && joules <= 1e9 && (i == 0 || point.nodes > points[i - 1].nodes);
  }
  if (sound) return {};
  return failure(Error{"device-invalid",
                       GLISSON_TEXT("Device {0} has measured points that are not positive, not by increasing nodes, or "
                                    "more than {1}."),
                       {device.id, std::to_string(maximum_measured_points)},
                       {},
                       {}});
}

}  // namespace
}  // namespace glisson::hardware
