// The plan's battery against a Panasonic 18650PF (Kollmeyer, doi 10.17632/wykht8y7tg) that no device of the table uses:
// MATLAB files, each one measurement. What sets the battery up and what is held apart stands at each test.

#include <gtest/gtest.h>
#include <matio.h>
#include <algorithm>
#include <cmath>
#include <memory>

#include "hardware/battery.h"
#include "measured_recordings.h"
#include "support/data.h"

namespace glisson::hardware {
namespace {

using test::report;

constexpr double label_Ah = 2.9;
constexpr double label_V = 3.6;

struct PanasonicRecording {
  std::vector<double> time_s, current_A, voltage_V;  // discharge positive
};

PanasonicRecording recording(const std::string& file) {
  const auto path = glisson::test::shared_data() / "battery_panasonic_18650pf" / file;
  const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close);
  if (!mat) throw std::runtime_error("cannot open " + path.string());
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> measured(Mat_VarRead(mat.get(), "meas"), Mat_VarFree);
  const auto values = [&](const char* name) {
    const matvar_t* field = Mat_VarGetStructFieldByName(measured.get(), name, 0);
    const auto* first = static_cast<const double*>(field->data);
    return std::vector<double>(first, first + field->dims[0] * field->dims[1]);
  };
  PanasonicRecording all{values("Time"), values("Current"), values("Voltage")};
  for (double& current : all.current_A) current = -current;
  return all;
}

struct Totals {
  double hours = 0, charge_Ah = 0, energy_Wh = 0;
  [[nodiscard]] double current_A() const { return charge_Ah / hours; }
  [[nodiscard]] double power_W() const { return energy_Wh / hours; }
  [[nodiscard]] double voltage_V() const { return energy_Wh / charge_Ah; }
};

// Of the first stretch under current.
Totals totals_of_discharge(const PanasonicRecording& r) {
  std::size_t begin = 0;
  while (r.current_A[begin] < 0.05) ++begin;
  Totals totals;
  for (std::size_t i = begin; i + 1 < r.time_s.size() && r.current_A[i + 1] > 0.05; ++i) {
    const double hours = (r.time_s[i + 1] - r.time_s[i]) / 3600;
    totals.hours += hours;
    totals.charge_Ah += hours * (r.current_A[i] + r.current_A[i + 1]) / 2;
    totals.energy_Wh += hours * (r.current_A[i] * r.voltage_V[i] + r.current_A[i + 1] * r.voltage_V[i + 1]) / 2;
  }
  return totals;
}

// Pulses of 10 s: what the voltage fell by at their end over their current, the median over the states of charge.
double resistance_ohm(const PanasonicRecording& r, double current_A) {
  std::vector<double> found;
  for (std::size_t i = 1; i < r.time_s.size(); ++i) {
    if (r.current_A[i] < 0.05 || r.current_A[i - 1] > 0.05) continue;
    std::size_t last = i;
    while (last + 1 < r.time_s.size() && r.current_A[last + 1] > 0.05) ++last;
    const double seconds = r.time_s[last] - r.time_s[i];
    if (seconds > 8 && seconds < 12 && std::abs(r.current_A[last] / current_A - 1) < 0.05)
      found.push_back((r.voltage_V[i - 1] - r.voltage_V[last]) / r.current_A[last]);
    i = last;
  }
  EXPECT_GT(found.size(), 5u);
  std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2), found.end());
  return found[found.size() / 2];
}

constexpr const char* slow_file =
    "Panasonic 18650PF Data/25degC/C20 OCV and 1C discharge tests_start_of_tests/"
    "05-08-17_13.26 C20 OCV Test_C20_25dC.mat";
constexpr const char* first_day =
    "Panasonic 18650PF Data/25degC/C20 OCV and 1C discharge tests_start_of_tests/03-09-17_17.59 3349_Dis1C_1.mat";
constexpr const char* next_day =
    "Panasonic 18650PF Data/25degC/C20 OCV and 1C discharge tests_start_of_tests/03-10-17_23.36 3349_Dis1C_2.mat";
constexpr const char* pulses_25C =
    "Panasonic 18650PF Data/25degC/5 pulse disch/03-11-17_08.47 25degC_5Pulse_HPPC_Pan18650PF.mat";
constexpr const char* pulses_0C = "0degC/5 pulse/05-20-17_10.44 0degC_5pulse_HPPC_Pan18650PF.mat";

// Set up: C/20 and the first day's 1C. Held apart: 1C of the next day. What a rate costs is Peukert's here.
TEST(HeldOutPanasonic, DischargeOfAnotherDay) {
  GLISSON_NEEDS_DATA("battery_panasonic_18650pf");
  const Totals slow = totals_of_discharge(recording(slow_file));
  const Totals fast = totals_of_discharge(recording(first_day));
  const Totals held = totals_of_discharge(recording(next_day));
  Battery battery;
  battery.capacity_Ah = slow.charge_Ah;
  battery.nominal_voltage_V = slow.voltage_V();
  battery.rated_hours = slow.hours;
  battery.rate_exponent = 1 + std::log(slow.charge_Ah / fast.charge_Ah) / std::log(fast.current_A() / slow.current_A());
  battery.internal_resistance_ohm = (slow.voltage_V() - fast.voltage_V()) / fast.current_A();
  const double before_h = drain({label_Ah, label_V}, held.power_W())->hours;
  const auto after = drain(battery, held.power_W());
  ASSERT_TRUE(after);
  report("Panasonic 1C, next day: time", held.hours, before_h, after->hours, "h");
  report("Panasonic 1C, next day: energy", held.energy_Wh, label_Ah * label_V, after->delivered_Wh, "Wh");
  EXPECT_NEAR(after->hours, held.hours, 0.03 * held.hours);
  EXPECT_LT(std::abs(after->hours - held.hours), std::abs(before_h - held.hours) / 2);
}

// Set up: pulses of 0.5C to 2C at 25 C. Held apart: pulses of 4C and 6C. Declared: no resistance, so that all is
// missing.
TEST(HeldOutPanasonic, PulsesFasterThanAnyItWasSetUpFrom) {
  GLISSON_NEEDS_DATA("battery_panasonic_18650pf");
  const PanasonicRecording pulses = recording(pulses_25C);
  double known_ohm = 0;
  for (const double rate : {0.5, 1.0, 2.0}) known_ohm += resistance_ohm(pulses, rate * label_Ah) / 3;
  for (const double rate : {4.0, 6.0}) {
    const double current_A = rate * label_Ah;
    const double sag_V = current_A * resistance_ohm(pulses, current_A);
    report(fmt::format("Panasonic pulse of {:g}C: voltage lost", rate), sag_V, 0, current_A * known_ohm, "V");
    EXPECT_NEAR(current_A * known_ohm, sag_V, 0.15 * sag_V);
  }
}

// Set up: one pulse size at 25 C and at 0 C. Held apart: the others at 0 C. Before: the warm cell's resistance. The
// rest is that a cold cell's resistance falls with the current, which the model does not have.
TEST(HeldOutPanasonic, ColdPulses) {
  GLISSON_NEEDS_DATA("battery_panasonic_18650pf");
  const PanasonicRecording warm = recording(pulses_25C);
  const PanasonicRecording cold = recording(pulses_0C);
  const double warm_ohm = resistance_ohm(warm, label_Ah);
  const double per_C = std::log(resistance_ohm(cold, label_Ah) / warm_ohm) / 25;  // as CellModel::resistance_per_C
  for (const double rate : {0.5, 2.0, 4.0}) {
    const double current_A = rate * label_Ah;
    const double held_V = current_A * resistance_ohm(cold, current_A);
    const double after_V = current_A * warm_ohm * std::exp(per_C * 25);
    report(fmt::format("Panasonic pulse of {:g}C at 0 C: voltage lost", rate), held_V, current_A * warm_ohm, after_V,
           "V");
    EXPECT_NEAR(after_V, held_V, 0.45 * held_V);
    EXPECT_LT(std::abs(after_V - held_V), std::abs(current_A * warm_ohm - held_V));
  }
}

}  // namespace
}  // namespace glisson::hardware
