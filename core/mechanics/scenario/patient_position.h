#pragma once
// How the patient lies on the table, and where gravity then points. Directions are in patient coordinates (LPS: x to
// the left, y to the back, z to the head).

#include <cmath>
#include <Eigen/Core>
#include <numbers>

#include "base/units.h"

namespace glisson::mechanics {

// From supine the table first tips, then rolls about its own long axis. A negative reverse Trendelenburg is
// Trendelenburg (the head down), a negative left tilt puts the right side down.
struct PatientPosition {
  double reverse_trendelenburg_deg = 0;  // the head up by this angle
  double left_tilt_deg = 0;              // the left side down by this angle
};
inline constexpr PatientPosition supine{};

// Towards the feet when the head is up, towards the left when the left side is down, else towards the back. The length
// is standard gravity.
inline Eigen::Vector3d gravity_mm_s2(const PatientPosition& position) {
  const double tip = position.reverse_trendelenburg_deg * std::numbers::pi / 180.0;
  const double roll = position.left_tilt_deg * std::numbers::pi / 180.0;
  return units::standard_gravity_mm_s2 *
         Eigen::Vector3d(std::sin(roll) * std::cos(tip), std::cos(roll) * std::cos(tip), -std::sin(tip));
}

}  // namespace glisson::mechanics
