#pragma once
// The device table and the convergence curve that ship.

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "platform/convergence_curve.h"
#include "platform/device_file.h"

namespace glisson::platform::test {

inline std::filesystem::path devices_file() {
  return std::filesystem::path(GLISSON_SOURCE_DIR) / "resources" / "devices" / "devices.json";
}

inline std::vector<Device> shipped_devices() {
  auto devices = read_devices(devices_file());
  EXPECT_TRUE(devices) << (devices ? "" : devices.error().message());
  return devices ? *devices : std::vector<Device>{};
}

inline ConvergenceCurve shipped_curve() {
  auto curve = read_convergence_curve(devices_file().parent_path() / "convergence.json");
  EXPECT_TRUE(curve) << (curve ? "" : curve.error().message());
  return curve ? *curve : ConvergenceCurve{};
}

inline const Device& device_named(const std::vector<Device>& devices, const std::string& id) {
  const auto found =
      std::find_if(devices.begin(), devices.end(), [&](const Device& device) { return device.id == id; });
  if (found == devices.end()) throw std::runtime_error("no device " + id);
  return *found;
}

}  // namespace glisson::platform::test
