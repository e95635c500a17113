#pragma once
// What a surgeon can wear for this case: the least obtrusive platform that holds. For each platform it says whether it
// holds, why not, and what would have to give.
//
// Sanity comes first: what the battery allows over the operation, against what the device draws when it does nothing.
// In table 6.2 that is 3.0 W against 2.8 W for the headset GPU, and 1.7 W against 5.5 W for the headset FPGA. For the
// backpacks it is 30.8 W against 30 W. A plan never hides that this headroom is nearly nil.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/convergence_curve.h"
#include "hardware/device.h"
#include "hardware/sentence.h"
#include "hardware/task.h"
#include "hardware/uncertainty.h"
#include "hardware/workload.h"

namespace glisson::hardware {

struct PlanRequest {
  double liver_volume_cm3 = 0;
  double accuracy_mm = 0;
  std::optional<double> youngs_kPa;  // mean of the liver; absent: as the convergence study's beam
  double duration_h = 3;             // the dissertation's resection; operations take 2 to 12 hours and more
  double frames_per_s = 10;          // 10 to 25 or more
  double ambient_C = 18;             // the dissertation's operating room
  double limit_C = 45;               // what a person should touch (section 6.5)
  WorkloadOptions workload;
  // What the product does in a frame (task.h), in place of the dissertation's block products for volume and accuracy.
  std::optional<Task> task = {};
};

enum class Constraint { idle_energy, idle_temperature, computing, throttling, energy, temperature };
std::string to_string(Constraint constraint);  // "idle-energy", "computing", ...

struct Reason {
  Constraint constraint = Constraint::computing;
  Sentence sentence;
};

// With nothing running.
struct Headroom {
  double idle_W = 0;      // at the battery
  double allowed_W = 0;   // what the battery allows over the operation
  double headroom_W = 0;  // the difference; negative where idling alone is too much
  double idle_h = 0;
  double idle_C = 0;  // at the end of the operation
};

// For each single figure the value at which, all else as asked, the platform would hold; absent where no value would.
struct Remedies {
  std::optional<double> duration_h;                  // at most
  std::optional<double> frames_per_s;                // at most
  std::optional<double> accuracy_mm;                 // at best; within the convergence study
  std::optional<double> battery_Wh;                  // at least
  std::optional<double> thermal_resistance_C_per_W;  // at most
};

struct DevicePlan {
  std::string id;
  std::string name;
  Worn worn = Worn::head;
  bool feasible = false;
  Certainty certainty;  // how sure that is; by plan() alone
  Headroom idle;
  // The frame rates up to which each constraint holds, and the minimum of them: what the platform can hold.
  double fps = 0;
  double fps_by_computing = 0;  // throttling included
  double fps_by_energy = 0;
  double fps_by_temperature = 0;
  // At the wanted frame rate, or at the fastest it can compute.
  double power_W = 0;
  double battery_h = 0;
  double temperature_C = 0;          // of the surface at the end of the operation
  double frame_joules = 0;           // above idle
  std::vector<Reason> reasons;       // why it fails; empty where it holds
  Remedies remedies;                 // empty where it holds
  std::vector<std::string> assumed;  // the figures of the device that nobody measured
};

struct Plan {
  PlanRequest request;
  Workload workload;
  std::vector<DevicePlan> platforms;       // in the order of the devices
  std::optional<std::string> recommended;  // least obtrusive that holds; among equals the coolest
  std::vector<Sentence> notes;             // what limits the plan itself
};

// Refused: frame rates, durations and temperatures that no operation has ("request-invalid").
Result<void> check(const PlanRequest& request);

// Of a platform's answer; the same question has the same certainty, to the bit.
[[nodiscard]] Certainty certainty_of(const Device& device, const Workload& workload, const PlanRequest& request);

// Refused: as by check(), and what workload.h and convergence_curve.h refuse.
Result<Plan> plan(const PlanRequest& request, const std::vector<Device>& devices, const ConvergenceCurve& curve);

// One platform at a given workload, without remedies: what grids are made of.
[[nodiscard]] DevicePlan answer_for(const Device& device, const Workload& workload, const PlanRequest& request);

}  // namespace glisson::hardware
