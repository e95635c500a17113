#pragma once
// One battery cell through a discharge: what its voltage and its temperature do. A model that is set up from a few
// measured discharges predicts others.
//
// Over depth of discharge d (0 full, 1 empty at a slow discharge):
//   V = U(d) - I R(d) exp(-b (T - 25 C)),     tau dT/dt = (T_ambient + R_th I (U - V)) - T
// U: open-circuit voltage; R: resistance, with everything that looks like one over minutes (contacts, charge transfer,
// diffusion); b: how it falls as the cell warms. The heat is what does not reach the terminals; the reversible heat of
// the reaction is left out. Valid for discharges of minutes to hours; pulses of seconds need more time constants.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/battery.h"
#include "hardware/heat.h"

namespace glisson::hardware {

// Samples by time.
struct Discharge {
  std::vector<double> time_s;         // increasing
  std::vector<double> current_A;      // positive while it discharges
  std::vector<double> voltage_V;      // at the terminals
  std::vector<double> temperature_C;  // of the cell
  double ambient_C = 0;               // the mean over the discharge

  [[nodiscard]] double seconds() const { return time_s.empty() ? 0 : time_s.back() - time_s.front(); }
  [[nodiscard]] double charge_Ah() const;
  [[nodiscard]] double energy_Wh() const;
  [[nodiscard]] double mean_current_A() const;
};

// Columns by name or by number from "1".
struct DischargeColumns {
  std::string time_s = "1";
  std::string current_A = "2";
  std::string voltage_V = "3";
  std::string temperature_C = "5";
  std::string ambient_C = "7";  // empty: the first temperature of the cell
  enum class Sign { discharge_positive, discharge_negative } sign = Sign::discharge_positive;
};

// Leading and trailing samples without current are dropped. Refused: fewer than 20 samples, time that goes back,
// readings that are missing ("discharge-invalid").
Result<Discharge> read_discharge(const std::filesystem::path& file, const DischargeColumns& columns);

struct CellModel {
  double capacity_Ah = 0;
  std::vector<double> open_circuit_V;  // at evenly spaced depths of discharge, from 0 to 1
  std::vector<double> resistance_ohm;  // at the same depths, at 25 C
  double resistance_per_C = 0;         // b
  double cutoff_V = 0;                 // where the discharge ends
  HeatModel heat;
};

// U(d) from `slow`, a discharge so slow that I R is small (C/10 and below; that rest is taken off with the R found);
// R(d) and b from `others` by least squares on the voltage; the heat model from their temperatures.
// Refused: fewer than two others, or others not at least five times as fast as the slow one ("discharges-too-alike").
Result<CellModel> cell_from(const Discharge& slow, const std::vector<Discharge>& others);

struct CellRun {
  Discharge discharge;      // at the time steps of the simulation
  double released_Wh = 0;   // out of the reaction: the integral of U I
  double delivered_Wh = 0;  // at the terminals
  double heat_Wh = 0;       // released = delivered + heat
};

// A full cell at ambient under a constant current until its cutoff voltage or its last charge.
[[nodiscard]] CellRun run_cell(const CellModel& cell, double current_A, double ambient_C, double step_s = 1);

// A measured discharge beside the cell's own at the same mean current and ambient temperature.
struct CellPrediction {
  CellRun run;
  double rms_voltage_V = 0;  // over the samples measured while both last
  double rms_temperature_C = 0;
};
[[nodiscard]] CellPrediction predict(const CellModel& cell, const Discharge& measured);

// The plan's battery for `in_series` such cells: the mean open-circuit voltage, the mean resistance at 25 C.
[[nodiscard]] Battery battery_of(const CellModel& cell, int in_series = 1);

}  // namespace glisson::hardware
