#pragma once
// How a worn computer and its battery answer what is asked of them. It has section 6's constant-energy battery and
// simple thermal model, and what may act on them. Every member stands at "does not act" until an effect (effects.h)
// changes it.
//
//   demand   P0 = idle + full load x load, or idle + V I where no load is recorded
//   power    P = ((P0 + static) (1 + c (T - T_ambient))) / efficiency
//   battery  V = V_nominal + curve(d) - I R until the capacity is spent, then 0; d: depth of discharge
//            charge counts as I (I / I_rated)^(k - 1) (Peukert), I_rated emptying the battery in the rated hours
//   heat     tau dT/dt = T_ambient + R_th P - T; without a time constant T follows P at once
// At the temperature limit the power is what keeps it there. Or, with steps, the computer works at a speed from 1 down
// to 0.05. The speed falls steadily above the limit and rises below it, so that it swings about the limit. This is the
// step-wise governor of Linux (Documentation/driver-api/thermal). The load then counts as load x speed. What drives
// that is the temperature predicted, second by second. The temperature that power depends on is the measured one where
// there is one. What heats is the power predicted, or the one measured where none is. Between samples power is as
// `hold` says.

#include <Eigen/Core>
#include <optional>

#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

struct HardwareBehaviour {
  double idle_W = 0;
  double full_load_W = 0;
  double nominal_voltage_V = 0;
  double capacity_Ah = 0;  // 0: never spent
  double thermal_resistance_C_per_W = 0;
  double time_constant_s = 0;

  double static_W = 0;
  double power_per_C = 0;
  double efficiency = 1;
  std::optional<double> limit_C;
  double slower_per_s = 0;  // of the speed; 0: no steps
  double faster_per_s = 0;
  double resistance_ohm = 0;
  bool heats_by_loss = false;  // I^2 R heats, not what is drawn: a cell by itself
  double rate_exponent = 1;
  double rated_hours = 5;
  double capacity_per_C = 0;          // of the capacity, against 25 C
  Eigen::VectorXd discharge_curve_V;  // curve(d) = sum of c_i d^i, i from 0; empty: none
};

[[nodiscard]] HardwareBehaviour declared_behaviour(const Hardware& hardware);

// At each time of the trial; empty where the declared model says nothing about the quantity.
struct HardwareReadings {
  Eigen::VectorXd voltage_V;
  Eigen::VectorXd temperature_C;
  Eigen::VectorXd power_W;
};
enum class Hold { mean_of_both, sample_before, sample_after };
[[nodiscard]] HardwareReadings readings(const HardwareBehaviour& behaviour, const Hardware& hardware,
                                        const HardwareTrial& trial, Hold hold = Hold::mean_of_both);

// Charge drawn since the trial began (Ah); zero where no current is recorded.
[[nodiscard]] Eigen::VectorXd charge_drawn_Ah(const HardwareTrial& trial);

}  // namespace glisson::closedloop
