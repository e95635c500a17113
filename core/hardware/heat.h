#pragma once
// How hot a worn computer gets: one thermal resistance to the room's air and one time constant (first order),
//
//   tau dT/dt = (T_ambient + R P) - T
//
// T being the surface that a person touches. It leaves out the blood that cools skin and what clothes keep in. It holds
// while R is constant: no fan that changes speed, no covering.

namespace glisson::hardware {

struct HeatModel {
  double resistance_C_per_W = 0;  // surface to air; > 0
  double time_constant_s = 0;     // > 0
};

[[nodiscard]] double steady_temperature_C(const HeatModel& model, double power_W, double ambient_C);

// After `elapsed_s` of constant power, from `start_C`: the closed form of the equation above.
[[nodiscard]] double temperature_after_C(const HeatModel& model, double start_C, double power_W, double ambient_C,
                                         double elapsed_s);

// When a surface that starts at `start_C` passes `limit_C`; 0 if it is there already, infinity if it never does.
[[nodiscard]] double time_to_reach_s(const HeatModel& model, double start_C, double power_W, double ambient_C,
                                     double limit_C);

// The largest constant power for which a surface that starts at ambient stays at or below `limit_C` for `elapsed_s`. 0
// if the room itself is as hot.
[[nodiscard]] double largest_power_W(const HeatModel& model, double ambient_C, double limit_C, double elapsed_s);

}  // namespace glisson::hardware
