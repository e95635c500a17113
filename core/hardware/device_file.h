#pragma once
// Devices as a file that people extend and share.
//
// {"format": "glisson-devices/1", "devices": [{"id": "tx2-gpu", "name": "...", "worn": "head", "worn_how": "...",
//   "idle_W": {"value": 2.8, "source": "dissertation", "note": "table 6.2"}, ...}]}
//
// The figures have the names in device.h; `battery` and `kernel` are objects of figures. What may be left out is taken
// as ideal:
//   device    supply_efficiency, throttle_C
//   battery   internal_resistance_ohm, rate_exponent, capacity_per_C
//   kernel    fast_memory_MB, fast_bandwidth_GB_s, launch_us, tile_nodes
// `kernel` may hold
//   "measured": {"nodes_in_domain": 1, "points": [{"nodes": 6000, "seconds": 1e-4, "joules": 2e-3}]}

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "hardware/device.h"

namespace glisson::hardware {

// Refused, naming file, device and key: unknown or missing keys, no battery, figures outside physical limits. So are a
// source that is none of figure.h's, two devices with one id, and more than 1000 devices.
Result<std::vector<Device>> read_devices(const std::filesystem::path& file);

// Adds devices to a table; one with an id that is there already takes that one's place.
void take_in(std::vector<Device> more, std::vector<Device>& devices);

Result<void> write_devices(const std::filesystem::path& file, const std::vector<Device>& devices);

}  // namespace glisson::hardware
