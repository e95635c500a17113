#pragma once
// The device table and the convergence curve that ship, and the dissertation's curve.

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "hardware/convergence_curve.h"
#include "hardware/device_file.h"
#include "support/folders.h"

namespace glisson::hardware::test {

inline std::filesystem::path devices_file() {
  return glisson::test::source_folder() / "resources" / "devices" / "devices.json";
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

// The power law through the ends of figure 6.5: 1 mm at 1.65 mm3 a node, 8 mm at 165. What the dissertation's own
// questions are asked with, however exact our engine is.
inline ConvergenceCurve dissertation_curve() {
  ConvergenceCurve curve;
  curve.source = Source::dissertation;
  curve.provenance = "figure 6.5";
  curve.youngs_kPa = 12;
  curve.points = {{1.65, 1}, {165, 8}};
  return curve;
}

inline const Device& device_named(const std::vector<Device>& devices, const std::string& id) {
  const auto found =
      std::find_if(devices.begin(), devices.end(), [&](const Device& device) { return device.id == id; });
  if (found == devices.end()) throw std::runtime_error("no device " + id);
  return *found;
}

}  // namespace glisson::hardware::test
