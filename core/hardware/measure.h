#pragma once
// This machine as a device to plan with. The block product is timed over the grid of problems, with its energy where a
// meter tells. What nobody can measure from inside is marked as assumed.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "hardware/block_product.h"
#include "hardware/device.h"
#include "hardware/energy_meter.h"
#include "hardware/grid.h"
#include "hardware/power_trace.h"

namespace glisson::hardware {

// What a program cannot see of the machine it runs on. Defaults are a laptop's, and show as assumed.
struct DeviceDescription {
  std::string id = "this-machine";
  std::string name = "This machine";
  Worn worn = Worn::back;
  std::string worn_how = "as the person who measured it says";
  std::optional<double> idle_W;                      // where no meter tells; assumed 10
  std::optional<double> active_W;                    // above idle, where no meter tells; assumed 20
  std::optional<double> capacity_mAh;                // assumed 4900
  std::optional<double> voltage_V;                   // assumed 11.6
  std::optional<double> thermal_resistance_C_per_W;  // assumed 0.8
  std::optional<double> thermal_time_constant_s;     // assumed 900
};

struct MeasureOptions {
  DeviceDescription device;
  ProblemGrid grid = dissertation_grid();
  int nodes_in_domain = 1;
  double idle_s = 3;                // listening before anything runs
  double seconds_per_point = 0.03;  // without a meter: long against the clock's grain; with one, at least as
                                    // long as the meter needs
  double longest_metering_s = 300;  // in all: a battery's gauge needs a minute a problem, so that some problems are
                                    // then timed alone and their energy follows from the active power of the others
  std::size_t bandwidth_array_bytes = std::size_t{96} << 20;  // of the triad that the share is stated against
  std::size_t largest_bytes = std::size_t{1} << 30;           // larger problems are left out, and said
};

struct MeasuredPoint {
  double nodes = 0;
  double bytes = 0;  // of one product: blocks and vector in, vector out
  double flops = 0;
  double seconds = 0;  // one product; in the fastest of five batches, as STREAM counts
  double GB_per_s = 0;
  double GFLOP_per_s = 0;
  double share_of_bandwidth = 0;      // above 1 where the problem stays in a cache; 0 where no bandwidth was measured
  bool in_cache = false;              // smaller than the processors' last cache
  std::optional<double> joules;       // above idle
  std::optional<double> uncertain_J;  // one standard deviation of what the meter resolves (EnergyUse)
};

struct Measurement {
  Device device;
  std::string kernel;                                          // what ran: "2 threads, AVX3"
  std::string meter;                                           // empty where there was none
  std::optional<double> idle_uncertain_W, active_uncertain_W;  // of a meter, as MeasuredPoint::uncertain_J
  double bandwidth_GB_s = 0;
  std::vector<MeasuredPoint> points;  // by increasing nodes
  std::vector<Sentence> remarks;      // what could not be measured, and why
};

// Takes about a quarter of a minute without a meter. `meter` may be null; `missing` are the survey's sentences, which
// become remarks then.
// Refused: what the kernel refuses for the smallest problem; a lost meter; no work left ("nothing-measured").
Result<Measurement> measure(ProductKernel& kernel, const EnergyMeter* meter, const std::vector<Sentence>& missing,
                            const MeasureOptions& options = {}, const Progress& progress = {});

// The power that a recording from outside shows takes the place of what was assumed or metered. Idle comes from its
// pauses, active from the median of its runs above idle. For a kernel that was timed on the recorded machine.
void take_power_from(const TraceRuns& runs, Measurement& measurement);
void take_power_from(const TraceRuns& runs, Device& device);

// A device from a recording and the log of what was run, with nothing run here. Refused as products_from_runs does.
Result<Measurement> measurement_from(const TraceRuns& runs, const std::vector<RunLog>& log,
                                     const MeasureOptions& options);

}  // namespace glisson::hardware
