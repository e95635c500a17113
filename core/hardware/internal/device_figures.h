#pragma once
// Every figure of a device, once: its name in files, its physical limits, and what is taken where a file leaves it out.

#include <optional>
#include <string>
#include <vector>

#include "hardware/device.h"

namespace glisson::hardware {

struct FigureSlot {
  const char* group;  // "", "battery" or "kernel": the object that holds it in a file
  const char* name;
  Figure& (*of)(Device& device);
  double minimum;
  double maximum;
  std::optional<double> ideal;  // what a file may leave out, and what that means

  [[nodiscard]] std::string full_name() const { return *group == '\0' ? name : std::string(group) + "." + name; }
  [[nodiscard]] const Figure& of_const(const Device& device) const { return of(const_cast<Device&>(device)); }
};

[[nodiscard]] const std::vector<FigureSlot>& figure_slots();

}  // namespace glisson::hardware
