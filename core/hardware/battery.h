#pragma once
// How long a battery carries a constant load, and where its energy goes.
//
// The declared battery holds capacity x nominal voltage and gives all of it. Three effects that the closed loop can
// find in measured discharges take from that:
//   internal resistance  V = V_nominal - I R, so I R of every volt becomes heat inside the cell;
//   rate capacity        Peukert: at current I only C (I_rated / I)^(k-1) of the capacity can be had, never more than
//   C; temperature          C (1 + a (T - 25 C)), never more than C.
// What cannot be had stays in the battery, so that stored = delivered + heat + left, always.
// Valid for a constant load and one nominal voltage; the shape of a cell's voltage is in cell.h.

#include "base/result.h"

namespace glisson::hardware {

struct Battery {
  double capacity_Ah = 0;        // > 0
  double nominal_voltage_V = 0;  // > 0
  double internal_resistance_ohm = 0;
  double rate_exponent = 1;   // Peukert's k, >= 1
  double rated_hours = 5;     // the discharge at which the capacity is stated; 5 h is usual for lithium cells
  double capacity_per_C = 0;  // a, the relative loss of capacity for each degree below 25 C

  [[nodiscard]] double energy_Wh() const { return capacity_Ah * nominal_voltage_V; }
};

struct Drain {
  double hours = 0;
  double current_A = 0;
  double stored_Wh = 0;     // what it held
  double delivered_Wh = 0;  // what the load got
  double heat_Wh = 0;       // lost inside the cell
  double left_Wh = 0;       // in the cell when it could give no more
};

// Refused: sizes that are not physical ("battery-invalid").
Result<void> check(const Battery& battery);

// A full battery under a constant load > 0, the cell at `battery_C` throughout.
// Refused: a load beyond what the internal resistance lets through ("battery-overloaded").
Result<Drain> drain(const Battery& battery, double load_W, double battery_C = 25);

// The largest constant load that the battery carries for so long; found by bisection on drain().
[[nodiscard]] double largest_load_W(const Battery& battery, double hours, double battery_C = 25);

}  // namespace glisson::hardware
