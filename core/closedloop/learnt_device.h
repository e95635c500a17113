#pragma once
// What a diagnosis learnt from a platform's recordings, as figures of a device that can be planned with.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/device.h"
#include "hardware/sentence.h"

namespace glisson::closedloop {

struct LearntDevice {
  hardware::Device device;
  std::vector<std::string> changed;         // the figures that are now measured, by their names in files
  std::vector<hardware::Sentence> remarks;  // what the plan has no figure for, and a verdict that is no proof
};

// `model_file` is the model.json that explain wrote for an experiment of kind "platform" that declared this device.
//   internal-resistance  battery.internal_resistance_ohm     static-power        added to idle_W
//   rate-capacity        battery.rate_exponent               supply-loss         times supply_efficiency
//   self-heating         battery.capacity_per_C              dynamic-power       kernel.active_W
//   discharge-curve      battery.voltage_V, by its mean      thermal-throttling  throttle_C
//   thermal-resistance   thermal_resistance_C_per_W          thermal-inertia     thermal_time_constant_s
// A Peukert exponent found for another rated time than the plan's 5 h is brought there by the capacity:
// C_5 = C (5 / h)^((k-1)/k) has the same charge at every current.
// Refused: "model-invalid"; figures outside a device's limits ("device-invalid").
Result<LearntDevice> learn_device(const hardware::Device& declared, const std::filesystem::path& model_file);

}  // namespace glisson::closedloop
