// Predictions against measurements that the models have not seen. For each: what sets the model up, what is held apart,
// the declared model's error (before) and the set-up model's (after). The numbers of docs/hardware-plan.md:
//
//   test_platform --gtest_filter='HeldOut*'

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "hardware/cell.h"
#include "measured_recordings.h"
#include "platform_fixtures.h"
#include "support/data.h"

namespace glisson::hardware {
namespace {

using test::report;

double relative_error(double predicted, double measured) { return std::abs(predicted / measured - 1); }

// --- Batteries: Samsung 30Q. Set up from C/10, 1C, 2C; held apart: 3C, 4C. -----------------------------------------

class HeldOutBattery : public testing::Test {
 protected:
  void SetUp() override {
    GLISSON_NEEDS_DATA("battery_samsung_30q");
    const auto cell = cell_from(discharge("C10"), {discharge("1C"), discharge("2C")});
    ASSERT_TRUE(cell) << cell.error().message();
    cell_ = *cell;
  }

  static Discharge discharge(const std::string& rate) {
    DischargeColumns columns;
    columns.sign = DischargeColumns::Sign::discharge_negative;
    const auto read = read_discharge(
        glisson::test::shared_data() / "battery_samsung_30q" / "S001" / ("Q30_S001_" + rate + ".csv"), columns);
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return read ? *read : Discharge{};
  }

  // Of a prediction that never moves.
  static double rms(const std::vector<double>& measured, double constant) {
    double sum = 0;
    for (const double value : measured) sum += std::pow(value - constant, 2);
    return std::sqrt(sum / static_cast<double>(measured.size()));
  }

  CellModel cell_;
};

TEST_F(HeldOutBattery, FasterDischargesThanAnyItWasSetUpFrom) {
  // Declared on the cell's label: 3.0 Ah at 3.6 V, no resistance, no warming.
  constexpr double label_Ah = 3.0;
  constexpr double label_V = 3.6;
  for (const char* rate : {"3C", "4C"}) {
    const Discharge measured = discharge(rate);
    const double current_A = measured.mean_current_A();
    const CellPrediction after = predict(cell_, measured);
    const Discharge& predicted = after.run.discharge;
    const double before_V = rms(measured.voltage_V, label_V);
    const double before_C = rms(measured.temperature_C, measured.ambient_C);
    std::cout << fmt::format(
        "held out: {} voltage rms {:.3f} -> {:.3f} V, temperature rms {:.1f} -> {:.1f} C, hottest {:.1f} C: {:.1f} -> "
        "{:.1f} C\n",
        rate, before_V, after.rms_voltage_V, before_C, after.rms_temperature_C, measured.temperature_C.back(),
        measured.ambient_C, predicted.temperature_C.back());
    report(std::string(rate) + " time to empty", measured.seconds(), label_Ah / current_A * 3600, predicted.seconds(),
           "s");
    report(std::string(rate) + " energy", measured.energy_Wh(), label_Ah * label_V, after.run.delivered_Wh, "Wh");
    // Thrice the scatter between the measured rates in voltage; in time and energy what a plan can use.
    EXPECT_LT(after.rms_voltage_V, before_V / 5);
    EXPECT_LT(after.rms_voltage_V, 0.06);
    EXPECT_LT(after.rms_temperature_C, 2);
    EXPECT_LT(relative_error(predicted.seconds(), measured.seconds()), 0.02);
    EXPECT_LT(relative_error(after.run.delivered_Wh, measured.energy_Wh()), 0.02);
  }
}

TEST_F(HeldOutBattery, PlansBatteryUnderConstantPower) {
  // The plan's battery is simpler: one voltage, one resistance. Time at the mean power of the discharge.
  const Battery battery = battery_of(cell_);
  for (const char* rate : {"3C", "4C"}) {
    const Discharge measured = discharge(rate);
    const double load_W = measured.energy_Wh() / (measured.seconds() / 3600);
    const double declared_h = drain({3.0, 3.6}, load_W)->hours;
    const double set_up_h = drain(battery, load_W)->hours;
    report(std::string(rate) + " time at mean power, plan's battery", measured.seconds() / 3600, declared_h, set_up_h,
           "h");
    EXPECT_LT(relative_error(set_up_h, measured.seconds() / 3600), 0.05);
    EXPECT_LT(relative_error(set_up_h, measured.seconds() / 3600),
              relative_error(declared_h, measured.seconds() / 3600));
  }
}

TEST_F(HeldOutBattery, ShippedHeadsetBatteryIsTwoOfTheseCells) {
  const Device device = test::device_named(test::shipped_devices(), "orin-nano-head");
  const Battery pair = battery_of(cell_, 2);
  // The table's figures are rounded to three digits.
  EXPECT_NEAR(device.battery.capacity_mAh.value * 1e-3, pair.capacity_Ah, 0.005 * pair.capacity_Ah);
  EXPECT_NEAR(device.battery.voltage_V.value, pair.nominal_voltage_V, 0.005 * pair.nominal_voltage_V);
  EXPECT_NEAR(device.battery.internal_resistance_ohm.value, pair.internal_resistance_ohm,
              0.01 * pair.internal_resistance_ohm);
}

// --- Power modes: Jetson AGX Xavier. Set up: both libraries at full clock (mode 0), one in the 30 W mode (3); held
// apart: the other library in that mode. ----------------------------------------------------------------------------

std::filesystem::path analyser_folder(const std::string& version, const std::string& system) {
  return glisson::test::shared_data() / "mlperf_edge_power" / version / "Krai" / system / "resnet50" / "singlestream";
}

TEST(HeldOutPower, OtherProgramInALowerPowerMode) {
  GLISSON_NEEDS_DATA("mlperf_edge_power");
  const auto full_a = test::analyser_run(analyser_folder("v1.1", "xavier-power.0-fan.cool-armnn-v21.05-neon"));
  const auto full_b = test::analyser_run(analyser_folder("v1.1", "xavier-power.0-fan.cool-tflite-v2.5.0-ruy"));
  const auto low_a = test::analyser_run(analyser_folder("v1.1", "xavier-power.3-fan.cool-armnn-v21.05-neon"));
  const auto held = test::analyser_run(analyser_folder("v1.1", "xavier-power.3-fan.cool-tflite-v2.5.0-ruy"));

  // A power mode scales a device's active power and its throughput, whatever runs; idle power stays.
  const double idle_W = (full_a.idle_W + full_b.idle_W + low_a.idle_W) / 3;
  const double power_factor = (low_a.active_W - idle_W) / (full_a.active_W - idle_W);
  const double speed_factor = low_a.queries_per_s / full_a.queries_per_s;
  const double predicted_W = idle_W + power_factor * (full_b.active_W - idle_W);
  const double predicted_rate = speed_factor * full_b.queries_per_s;
  // Declared: the mode's budget of 30 W, and the throughput that was known.
  report("Xavier 30 W mode, other library: power", held.active_W, 30, predicted_W, "W");
  report("Xavier 30 W mode, other library: throughput", held.queries_per_s, full_b.queries_per_s, predicted_rate,
         "1/s");
  report("Xavier 30 W mode, other library: energy a query", held.active_W / held.queries_per_s,
         30 / full_b.queries_per_s, predicted_W / predicted_rate, "J");
  EXPECT_LT(relative_error(predicted_W, held.active_W), 0.10);
  EXPECT_LT(relative_error(predicted_rate, held.queries_per_s), 0.05);

  // What the device table says of these modes is what was measured.
  const auto devices = test::shipped_devices();
  const Device& full = test::device_named(devices, "agx-xavier-cpu");
  const Device& low = test::device_named(devices, "agx-xavier-cpu-30w");
  EXPECT_NEAR(full.idle_W.value, idle_W, 0.1);
  EXPECT_NEAR(full.kernel.active_W.value, full_a.active_W - idle_W, 0.1);
  EXPECT_NEAR(low.kernel.active_W.value, low_a.active_W - idle_W, 0.1);
}

TEST(HeldOutPower, SecondHalfOfEachRunFromItsFirst) {
  GLISSON_NEEDS_DATA("mlperf_edge_power");
  const auto devices = test::shipped_devices();
  struct Row {
    const char* system;
    const char* device;
  };
  for (const Row& row : {Row{"odroid-armnn-v21.11-neon", "odroid-n2-cpu"},
                         Row{"odroid-armnn-v21.11-opencl", "odroid-n2-gpu"}, Row{"odroid-tflite-v2.7.1-ruy", ""}}) {
    const auto run = test::analyser_run(analyser_folder("v2.0", row.system));
    const std::size_t half = run.window_W.size() / 2;
    double first_W = 0;
    double second_W = 0;
    for (std::size_t i = 0; i < half; ++i) {
      first_W += run.window_W[i] / static_cast<double>(half);
      second_W += run.window_W[half + i] / static_cast<double>(half);
    }
    // Declared: idle alone. A constant active power is what the plan assumes over hours; warming would show here.
    report(std::string(row.system) + ": second five minutes", second_W, run.idle_W, first_W, "W");
    EXPECT_LT(relative_error(first_W, second_W), 0.03);
    if (*row.device == '\0') continue;
    const Device& device = test::device_named(devices, row.device);
    EXPECT_NEAR(device.idle_W.value, run.idle_W, 0.1);
    EXPECT_NEAR(device.kernel.active_W.value, run.active_W - run.idle_W, 0.1);
  }
}

// --- Rails of a Jetson TX2 under video. Set up: idle and three clips of each kind; held apart: two clips. -----------

TEST(HeldOutPower, ClipsOfAKindOnTheTx2) {
  GLISSON_NEEDS_DATA("jetson_tx2_rail_power");
  const auto folder = glisson::test::shared_data() / "jetson_tx2_rail_power";
  const auto total_W = [&](const std::string& kind, const std::string& clip) {
    double total = 0;
    for (const char* rail : {"cpu", "gpu", "ddr", "soc", "wifi"})
      total += test::mean_of_lines(folder / kind / (clip + "_" + rail + ".txt")) * 1e-3;
    return total;
  };
  const double idle_W = total_W("idle", "idle");
  std::cout << fmt::format("TX2 rails at idle: {:.2f} W of the 2.8 W that table 6.2 has for the board\n", idle_W);
  EXPECT_LT(idle_W, 2.8);
  for (const std::string kind : {"1080p", "4k_360"}) {
    const double above_idle_W =
        (total_W(kind, "elephant") + total_W(kind, "nyc") + total_W(kind, "paris")) / 3 - idle_W;
    for (const std::string clip : {"rhino", "roller"}) {
      const double measured_W = total_W(kind, clip);
      report("TX2 " + kind + " " + clip, measured_W, idle_W, idle_W + above_idle_W, "W");
      // Video clips of a kind differ by a quarter in what they ask of the processor at 1080p, which nothing here could
      // predict; idle alone is off by two thirds.
      EXPECT_LT(relative_error(idle_W + above_idle_W, measured_W), kind == "1080p" ? 0.30 : 0.05);
      EXPECT_LT(relative_error(idle_W + above_idle_W, measured_W), relative_error(idle_W, measured_W));
    }
  }
}

}  // namespace
}  // namespace glisson::hardware
