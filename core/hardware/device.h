#pragma once
// A wearable computer as the plan sees it: its draw when idle, its battery, how it warms, and how it is worn. A block
// product costs it time and energy. Every figure carries its source.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/battery.h"
#include "hardware/figure.h"
#include "hardware/heat.h"
#include "hardware/workload.h"

namespace glisson::hardware {

// The least obtrusive comes first: nothing between the surgeon and the patient. Then come one cable to the hip, and a
// load on the back that restricts movement (section 6.1).
enum class Worn { head, belt, back };

// The kernel as it was timed on the device (platform measure).
struct MeasuredProduct {
  double nodes = 0;
  double seconds = 0;            // one product
  std::optional<double> joules;  // above idle; absent where the machine tells nobody
};

// A block product's time and energy. Where `measured` has points, they win: straight lines in log-log between them,
// and beyond the last one in proportion to the bytes. Elsewhere a roofline:
//   time   = launch + max(bytes in whole tiles / bandwidth, flops in whole tiles / peak)
//   energy = active x time + energy per byte x bytes          (above idle)
// with the fast memory's bandwidth as long as the product's bytes fit into it. The two step functions (tiles, fast
// memory) are what makes "hot spots" in figures 6.9a and 6.9b possible in a smooth model.
struct KernelModel {
  Figure bandwidth_GB_s;  // reached by the product from main memory
  Figure peak_GFLOPS;
  Figure fast_memory_MB;                  // cache or memory on chip that a problem can stay in; 0 for none
  Figure fast_bandwidth_GB_s;             // reached from there
  Figure launch_us;                       // before each product
  Figure tile_nodes;                      // nodes are worked off in whole tiles of so many; 1 for no padding
  Figure active_W;                        // above idle, while a product runs, whatever it moves
  Figure energy_nJ_per_byte;              // above that, for each byte moved
  int measured_nodes_in_domain = 1;       // the blocks that `measured` was taken with
  std::vector<MeasuredProduct> measured;  // by increasing nodes
};

inline constexpr double never_throttles_C = 200;

struct DeviceBattery {
  Figure capacity_mAh;
  Figure voltage_V;
  Figure internal_resistance_ohm;
  Figure rate_exponent;   // 1: capacity does not depend on the rate
  Figure capacity_per_C;  // 0: nor on the temperature
};

struct Device {
  std::string id;    // "tx2-gpu": small letters, digits and dashes
  std::string name;  // "Jetson TX2 (GPU)"
  Worn worn = Worn::head;
  std::string worn_how;  // "strapped to the head, watch-size battery"
  Figure idle_W;
  Figure supply_efficiency;  // of the converter between battery and device; 1 where idle_W was taken at the battery
  DeviceBattery battery;
  Figure thermal_resistance_C_per_W;
  Figure thermal_time_constant_s;
  Figure throttle_C;  // the surface temperature at which the device slows itself down to get no hotter
  KernelModel kernel;
};

struct ProductCost {
  double seconds = 0;
  double joules = 0;  // above idle
};

[[nodiscard]] Battery battery_of(const Device& device);
[[nodiscard]] HeatModel heat_of(const Device& device);
[[nodiscard]] ProductCost product_cost(const Device& device, const Workload& workload);

// Mean power of the device at a frame rate; beyond what it can compute it runs without pause, at most at
// fastest_frames_per_s. What is asked of the battery is this over the supply's efficiency.
[[nodiscard]] double fastest_frames_per_s(const Device& device, const Workload& workload);
[[nodiscard]] double power_W(const Device& device, const Workload& workload, double frames_per_s);

// All figures of the device, by the names that they have in files ("idle_W", "battery.voltage_V").
struct NamedFigure {
  std::string name;
  Figure figure;
};
[[nodiscard]] std::vector<NamedFigure> figures_of(const Device& device);

// The names of those that are assumed.
[[nodiscard]] std::vector<std::string> assumed_figures(const Device& device);

std::string to_string(Worn worn);      // "head", "belt", "back"
std::string to_string(Source source);  // "measured", "computed", "dissertation", "assumed"

// Refused: figures that are not physical, measured points out of order ("device-invalid", naming the device, the
// figure and its limits).
Result<void> check(const Device& device);

}  // namespace glisson::hardware
