#include "hardware/measure.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "base/stopwatch.h"
#include "base/upper_median.h"

namespace glisson::hardware {
namespace {

constexpr int batches_per_point = 5;
constexpr double renewals_of_a_point = 5;
constexpr double quiet_spread = 1.25;  // the median of the batches over the fastest; a quiet machine stays below

struct Timing {
  double seconds = 0;  // one product
  double spread = 1;   // median of the batches over the fastest
  std::optional<double> joules;
  std::optional<double> uncertain_J;
};

// As its maker says, or as it was seen while nothing ran; 0 where neither.
double renewal_s(const EnergyMeter& meter, const EnergyUse& idle) {
  return meter.renewal_s.value_or(idle.renewed_every_s.value_or(0));
}

std::vector<std::size_t> sizes_of(const ProblemGrid& grid);
Result<std::size_t> prepare_largest(ProductKernel& kernel, std::vector<std::size_t>& sizes,
                                    std::vector<Sentence>& remarks);
Result<EnergyUse> use_when_idle(const EnergyMeter& meter, double listening_s);
Result<Timing> time_product(ProductKernel& kernel, std::size_t nodes, const EnergyMeter* meter, const EnergyUse& idle,
                            double at_least_s);
Sentence renewal_of(const EnergyMeter& meter, const EnergyUse& idle, double metered_s);
std::optional<double> uncertain_W(const EnergyUse& use);
std::string give_or_take(const std::optional<double>& uncertain_W);
Result<MeasuredPoint> point_for(const MeasuredProduct& product, int nodes_in_domain, double bandwidth_GB_s);
Device described(const DeviceDescription& description);
void set_kernel(int nodes_in_domain, Measurement& measurement);

}  // namespace

Result<Measurement> measure(ProductKernel& kernel, const EnergyMeter* meter, const std::vector<Sentence>& missing,
                            const MeasureOptions& options, const Progress& progress) {
  Measurement measurement;
  measurement.kernel = kernel.name();
  measurement.device = described(options.device);
  measurement.remarks = missing;
  EnergyUse idle;
  double metered_s = options.seconds_per_point;
  if (meter != nullptr) {
    measurement.meter = meter->name;
    progress.report(0, GLISSON_TEXT("Idle power"));
    const auto listened = use_when_idle(*meter, std::max(options.idle_s, meter->shortest_useful_s));
    if (!listened) return failure(listened.error());
    idle = *listened;
    metered_s = std::max({metered_s, meter->shortest_useful_s, renewals_of_a_point * renewal_s(*meter, idle)});
    measurement.idle_uncertain_W = uncertain_W(idle);
    measurement.device.idle_W = {idle.mean_W(), Source::measured,
                                 meter->name + ", with nothing running" + give_or_take(measurement.idle_uncertain_W)};
    measurement.remarks.push_back(renewal_of(*meter, idle, metered_s));
  } else {
    measurement.remarks.push_back(
        {GLISSON_TEXT(
             "Nothing on this machine tells its energy: idle and active power are assumed. Measure them with a "
             "current clamp or a power meter, and give them."),
         {}});
  }

  std::vector<std::size_t> sizes = sizes_of(options.grid);
  progress.report(0.05, GLISSON_TEXT("Memory bandwidth"));
  measurement.bandwidth_GB_s = memory_bandwidth_GB_s(options.bandwidth_array_bytes);
  const auto prepared = prepare_largest(kernel, sizes, measurement.remarks);
  if (!prepared) return failure(prepared.error());

  const double all_metered_s = metered_s * static_cast<double>(sizes.size());
  const auto meter_every =
      static_cast<std::size_t>(std::ceil(std::max(1.0, all_metered_s / options.longest_metering_s)));
  std::vector<double> spreads;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(sizes.size()),
                    GLISSON_TEXT("Block products"));
    const bool metered = meter != nullptr && i % meter_every == 0;
    const auto timing = time_product(kernel, sizes[i], metered ? meter : nullptr, idle,
                                     metered ? metered_s : options.seconds_per_point);
    if (!timing) return failure(timing.error());
    const auto point = point_for({static_cast<double>(sizes[i]), timing->seconds, timing->joules},
                                 options.nodes_in_domain, measurement.bandwidth_GB_s);
    if (!point) return failure(point.error());
    measurement.points.push_back(*point);
    measurement.points.back().uncertain_J = timing->uncertain_J;
    measurement.points.back().in_cache = point->bytes < static_cast<double>(largest_cache_bytes());
    spreads.push_back(timing->spread);
  }
  if (const double spread = upper_median(std::move(spreads)); spread > quiet_spread) {
    measurement.remarks.push_back(
        {GLISSON_TEXT("Other work disturbed the timing: batches usually took {0} times as long as the fastest one. "
                      "Measure again on a quiet machine."),
         {fmt::format("{:.1f}", spread)}});
  }
  set_kernel(options.nodes_in_domain, measurement);
  return measurement;
}

void take_power_from(const TraceRuns& runs, Device& device) {
  device.idle_W = {runs.idle_W, Source::measured, "recording, median of the pauses"};
  if (!runs.runs.empty())
    device.kernel.active_W = {runs.above_idle_W(), Source::measured, "recording, median of the runs above idle"};
}

void take_power_from(const TraceRuns& runs, Measurement& measurement) {
  take_power_from(runs, measurement.device);
  measurement.remarks.insert(measurement.remarks.end(), runs.warnings.begin(), runs.warnings.end());
}

Result<Measurement> measurement_from(const TraceRuns& runs, const std::vector<RunLog>& log,
                                     const MeasureOptions& options) {
  const auto products = products_from_runs(runs, log);
  if (!products) return failure(products.error());
  Measurement measurement;
  measurement.kernel = "as logged beside the recording";
  measurement.meter = "recording";
  measurement.device = described(options.device);
  for (const MeasuredProduct& product : *products) {
    const auto point = point_for(product, options.nodes_in_domain, 0);
    if (!point) return failure(point.error());
    measurement.points.push_back(*point);
  }
  set_kernel(options.nodes_in_domain, measurement);
  take_power_from(runs, measurement);
  return measurement;
}

namespace {

std::vector<std::size_t> sizes_of(const ProblemGrid& grid) {
  std::set<std::size_t> sizes;
  for (const double volume_cm3 : grid.volumes_cm3) {
    for (const double resolution_mm3 : grid.resolutions_mm3)
      sizes.insert(static_cast<std::size_t>(std::ceil(volume_cm3 * 1e3 / resolution_mm3)));
  }
  return {sizes.begin(), sizes.end()};
}

// The batch for the largest size that fits serves all smaller ones.
Result<std::size_t> prepare_largest(ProductKernel& kernel, std::vector<std::size_t>& sizes,
                                    std::vector<Sentence>& remarks) {
  const std::size_t wanted = sizes.size();
  Result<void> prepared = failure("nothing-measured", GLISSON_TEXT("The grid holds no problem."));
  while (!sizes.empty()) {
    prepared = kernel.prepare(sizes.back());
    if (prepared) break;
    sizes.pop_back();
  }
  if (!prepared) return failure(prepared.error());
  if (sizes.size() < wanted) {
    remarks.push_back(
        {GLISSON_TEXT("{0} of {1} problems are larger than the memory allowed and were left out; beyond {2} "
                      "nodes the plan goes on in proportion."),
         {std::to_string(wanted - sizes.size()), std::to_string(wanted), std::to_string(sizes.back())}});
  }
  return sizes.back();
}

Result<EnergyUse> use_when_idle(const EnergyMeter& meter, double listening_s) {
  return energy_during(meter, [listening_s]() -> Result<void> {
    std::this_thread::sleep_for(std::chrono::duration<double>(listening_s));
    return {};
  });
}

// How often the meter says something new, and how long it is listened to therefore.
Sentence renewal_of(const EnergyMeter& meter, const EnergyUse& idle, double metered_s) {
  const std::string each = fmt::format("{:.2g}", metered_s);
  if (!meter.renewal_s && !idle.renewed_every_s) {
    return {
        GLISSON_TEXT("{0} gave one reading in {1} s: how sure it is cannot be told. Each metered problem runs {2} s."),
        {meter.name, fmt::format("{:.2g}", idle.seconds), each}};
  }
  return {
      GLISSON_TEXT("{0} is renewed every {1} s: each metered problem runs {2} s. What follows \"give or take\" is what "
                   "that resolves; how true the readings are was not checked."),
      {meter.name, fmt::format("{:.2g}", renewal_s(meter, idle)), each}};
}

std::optional<double> uncertain_W(const EnergyUse& use) {
  return use.uncertain_J ? std::optional(*use.uncertain_J / use.seconds) : std::nullopt;
}

std::string give_or_take(const std::optional<double>& uncertain_W) {
  return uncertain_W ? fmt::format(", give or take {:.2g} W", *uncertain_W) : ", a single reading";
}

Result<Timing> time_product(ProductKernel& kernel, std::size_t nodes, const EnergyMeter* meter, const EnergyUse& idle,
                            double at_least_s) {
  // Twice as many until a batch takes a fifth of the time wanted: warms caches and clocks as well.
  int times = 1;
  for (;; times *= 2) {
    const Stopwatch watch;
    if (const auto run = kernel.run(nodes, times); !run) return failure(run.error());
    if (watch.seconds() >= at_least_s / batches_per_point || times >= 1 << 24) break;
  }
  std::vector<double> seconds;
  const auto all_batches = [&]() -> Result<void> {
    for (int batch = 0; batch < batches_per_point; ++batch) {
      const Stopwatch watch;
      if (const auto run = kernel.run(nodes, times); !run) return failure(run.error());
      seconds.push_back(watch.seconds() / times);
    }
    return {};
  };
  Timing timing;
  if (meter != nullptr) {
    const auto use = energy_during(*meter, all_batches);
    if (!use) return failure(use.error());
    const double above_idle_J = use->joules - idle.mean_W() * use->seconds;
    const double products = static_cast<double>(times) * batches_per_point;
    // Noise may hide a small problem's share; such a point is left without energy.
    if (above_idle_J > 0) timing.joules = above_idle_J / products;
    const auto idle_uncertain_W = uncertain_W(idle);
    if (timing.joules && use->uncertain_J && idle_uncertain_W)
      timing.uncertain_J = std::hypot(*use->uncertain_J, *idle_uncertain_W * use->seconds) / products;
  } else if (const auto run = all_batches(); !run) {
    return failure(run.error());
  }
  timing.seconds = *std::min_element(seconds.begin(), seconds.end());
  timing.spread = upper_median(std::move(seconds)) / timing.seconds;
  return timing;
}

Result<MeasuredPoint> point_for(const MeasuredProduct& product, int nodes_in_domain, double bandwidth_GB_s) {
  // 1000 cm3 is any liver: only the number of nodes matters here.
  const auto work = workload_at_resolution(1000, 1e6 / product.nodes, {nodes_in_domain, 1, 4});
  if (!work) return failure(work.error());
  MeasuredPoint point;
  point.nodes = product.nodes;
  point.seconds = product.seconds;
  point.joules = product.joules;
  point.bytes = work->product_bytes;
  point.flops = work->product_flops;
  point.GB_per_s = work->product_bytes / product.seconds * 1e-9;
  point.GFLOP_per_s = work->product_flops / product.seconds * 1e-9;
  if (bandwidth_GB_s > 0) point.share_of_bandwidth = point.GB_per_s / bandwidth_GB_s;
  return point;
}

Device described(const DeviceDescription& description) {
  const auto given_or = [](const std::optional<double>& given, double otherwise, const char* usual) {
    return given ? Figure{*given, Source::assumed, "as given by the person who measured"}
                 : Figure{otherwise, Source::assumed, usual};
  };
  const auto ideal = [](double value) { return Figure{value, Source::assumed, "taken as ideal"}; };
  Device device;
  device.id = description.id;
  device.name = description.name;
  device.worn = description.worn;
  device.worn_how = description.worn_how;
  device.idle_W = given_or(description.idle_W, 10, "usual of a laptop; this machine tells nobody");
  device.supply_efficiency = ideal(1);
  device.battery.capacity_mAh = given_or(description.capacity_mAh, 4900, "usual of a laptop, 57 Wh");
  device.battery.voltage_V = given_or(description.voltage_V, 11.6, "three lithium cells in series");
  device.battery.internal_resistance_ohm = ideal(0);
  device.battery.rate_exponent = ideal(1);
  device.battery.capacity_per_C = ideal(0);
  device.thermal_resistance_C_per_W =
      given_or(description.thermal_resistance_C_per_W, 0.8, "usual of a fan-cooled laptop");
  device.thermal_time_constant_s = given_or(description.thermal_time_constant_s, 900, "about 1.4 kg");
  device.throttle_C = {never_throttles_C, Source::assumed, "not observed: taken as never"};
  device.kernel.active_W = given_or(description.active_W, 20, "usual of a laptop; this machine tells nobody");
  return device;
}

void set_kernel(int nodes_in_domain, Measurement& measurement) {
  KernelModel& kernel = measurement.device.kernel;
  const MeasuredPoint& largest = measurement.points.back();
  const std::string by = "block product, " + measurement.kernel;
  double peak = 0;
  std::vector<std::pair<double, std::optional<double>>> active_W;  // with how uncertain it is
  for (const MeasuredPoint& point : measurement.points) {
    peak = std::max(peak, point.GFLOP_per_s);
    if (point.joules) {
      active_W.emplace_back(*point.joules / point.seconds,
                            point.uncertain_J ? std::optional(*point.uncertain_J / point.seconds) : std::nullopt);
    }
    kernel.measured.push_back({point.nodes, point.seconds, point.joules});
  }
  kernel.measured_nodes_in_domain = nodes_in_domain;
  // For blocks of another size: the bandwidth of the largest problem, and never more operations than were seen.
  kernel.bandwidth_GB_s = {largest.GB_per_s, Source::measured, by + ", largest problem"};
  kernel.peak_GFLOPS = {peak, Source::measured, by + ", fastest problem: a lower bound"};
  kernel.fast_memory_MB = {0, Source::assumed, "not told apart: the measured points contain it"};
  kernel.fast_bandwidth_GB_s = {largest.GB_per_s, Source::measured, by + ", largest problem"};
  kernel.launch_us = {0, Source::assumed, "contained in the measured points"};
  kernel.tile_nodes = {1, Source::assumed, "contained in the measured points"};
  kernel.energy_nJ_per_byte = {0, Source::assumed, "contained in the active power"};
  if (!active_W.empty()) {
    std::sort(active_W.begin(), active_W.end());
    const auto& [median_W, uncertain_W] = active_W[active_W.size() / 2];
    measurement.active_uncertain_W = uncertain_W;
    // A recording's median says of itself how it was got.
    kernel.active_W = {median_W, Source::measured,
                       measurement.meter + ", above idle, median" +
                           (measurement.idle_uncertain_W ? give_or_take(uncertain_W) : std::string())};
  }
}

}  // namespace
}  // namespace glisson::hardware
