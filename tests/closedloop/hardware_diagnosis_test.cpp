// Recordings of batteries and boards with a known undeclared effect back to the effect.

#include <gmock/gmock.h>
#include <cmath>
#include <functional>
#include <random>

#include "base/files.h"
#include "closedloop/explanation_file.h"
#include "closedloop/hardware/model.h"
#include "closedloop/inference/diagnosis.h"

namespace glisson::closedloop {
namespace {

std::mt19937& random_numbers() {
  static std::mt19937 random(4);
  return random;
}

double noise(double deviation) { return std::normal_distribution<double>(0, deviation)(random_numbers()); }

// A cell of 3.6 V and 3 Ah, emptied at three currents and in pulses; `drop` is what its voltage lacks.
Hardware cell(const std::function<double(double current_A)>& drop_V, double peukert) {
  Hardware hardware;
  hardware.nominal_voltage_V = 3.6;
  hardware.capacity_Ah = 3;
  hardware.noise_V = 0.01;
  for (const double current_A : {1.0, 2.0, 4.0, -3.0}) {  // -3: pulses of 3 A
    HardwareTrial trial;
    trial.id = std::to_string(current_A);
    constexpr int samples = 240;
    const double mean_A = current_A > 0 ? current_A : 1.5;
    trial.time_s = Eigen::VectorXd::LinSpaced(samples, 0, 1.1 * 3600 * 3 / mean_A);
    trial.current_A.resize(samples);
    trial.voltage_V.resize(samples);
    double spent_Ah = 0;
    for (Eigen::Index i = 0; i < samples; ++i) {
      trial.current_A[i] = current_A > 0 ? current_A : (i / 10 % 2 == 0 ? 3.0 : 0.0);
      if (i > 0) {
        const double mean = (trial.current_A[i] + trial.current_A[i - 1]) / 2;
        constexpr double rated_A = 3.0 / 5;
        const double rate = mean > 0 ? std::pow(mean / rated_A, peukert - 1) : 1;
        spent_Ah += mean * rate * (trial.time_s[i] - trial.time_s[i - 1]) / 3600;
      }
      trial.voltage_V[i] = (spent_Ah <= 3 ? 3.6 - drop_V(trial.current_A[i]) : 0) + noise(0.01);
    }
    hardware.trials.push_back(trial);
  }
  return hardware;
}

struct Board {
  double static_W = 0;
  double efficiency = 1;
  double limit_C = 1000;
  double slower_per_s = 0, faster_per_s = 0;  // of its speed, above and below the limit; none: held at the limit
};

TEST(HardwareModel, TakesALearntModelWhereTemperatureWasNotRecorded) {
  // "internal-resistance", heating: learnt from cells whose warmth was seen.
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "m.json",
                              R"({"format": "glisson-closedloop-model/1", "kind": "platform",
                                  "effects": [{"kind": "internal-resistance", "law": "heating",
                                               "parameters": {"resistance_ohm": 0.05}}]})"));
  for (const bool with_temperature : {true, false}) {
    Hardware hardware = cell([](double) { return 0.0; }, 1);
    hardware.thermal_resistance_C_per_W = 5;
    hardware.noise_C = 0.2;
    if (with_temperature)
      for (HardwareTrial& trial : hardware.trials)
        trial.temperature_C = Eigen::VectorXd::Constant(trial.time_s.size(), trial.ambient_C);
    const auto model = hardware_model(hardware).value();
    const auto better = read_model(folder.path() / "m.json", *model, {"e.json", "", hardware});
    ASSERT_TRUE(better) << better.error().message();
    const Eigen::VectorXd drop = model->predict({}).value() - predict_with(*model, *better).value();
    EXPECT_NEAR(drop[0], 0.05, 1e-9) << with_temperature;  // 1 A
  }
}

// A board that idles at 2 W and takes 8 W more at full load, 5 C/W and 120 s to the room's air.
Hardware board(const Board& board) {
  Hardware hardware;
  hardware.idle_W = 2;
  hardware.full_load_W = 8;
  hardware.thermal_resistance_C_per_W = 5;
  hardware.time_constant_s = 120;
  hardware.noise_W = 0.1;
  hardware.noise_C = 0.3;
  for (const double top : {0.4, 0.7, 1.0, 0.9}) {
    HardwareTrial trial;
    trial.id = std::to_string(top);
    trial.ambient_C = 23;
    constexpr int samples = 180;
    trial.time_s = Eigen::VectorXd::LinSpaced(samples, 0, 900);
    trial.load.resize(samples);
    trial.power_W.resize(samples);
    trial.temperature_C.resize(samples);
    double temperature = 23, speed = 1;
    for (Eigen::Index i = 0; i < samples; ++i) {
      trial.load[i] = top * (0.5 + 0.5 * std::sin(0.004 * trial.time_s[i] * (1 + top)));
      const auto drawn = [&] { return (2 + 8 * trial.load[i] * speed + board.static_W) / board.efficiency; };
      constexpr int steps = 50;
      for (int step = 0; step < steps && i > 0; ++step) {
        const double rate = temperature > board.limit_C ? -board.slower_per_s : board.faster_per_s;
        speed = std::clamp(speed + rate * 5 / steps, 0.05, 1.0);
        temperature += (23 + 5 * drawn() - temperature) * 5 / 120 / steps;
      }
      double power = drawn();
      if (board.slower_per_s == 0 && temperature >= board.limit_C) {
        temperature = board.limit_C;
        power = std::min(power, (board.limit_C - 23) / 5);
      }
      trial.power_W[i] = power + noise(0.1);
      trial.temperature_C[i] = temperature + noise(0.3);
    }
    hardware.trials.push_back(trial);
  }
  return hardware;
}

Explanation explained(const Hardware& hardware) {
  const auto model = hardware_model(hardware);
  EXPECT_TRUE(model);
  return diagnose(**model).value();
}

std::string name_of_only_effect(const Explanation& e) {
  return e.effects.size() == 1 && e.verdict == Verdict::explained ? e.effects[0].kind : "not one";
}

const auto no_drop = [](double) { return 0.0; };

TEST(PlatformTracing, NothingIsAddedToPlatformsThatAreAsDeclared) {
  EXPECT_EQ(explained(cell(no_drop, 1)).verdict, Verdict::nothing_missing);
  EXPECT_EQ(explained(board({})).verdict, Verdict::nothing_missing);
}

TEST(PlatformTracing, ACellsResistanceAndItsLossOfCapacityAreFound) {
  const Explanation resistance = explained(cell([](double current_A) { return 0.03 * current_A; }, 1));
  ASSERT_EQ(name_of_only_effect(resistance), "internal-resistance");
  EXPECT_NEAR(resistance.effects[0].parameters[0].value, 0.03, 0.001);
  const Explanation rate = explained(cell(no_drop, 1.1));
  ASSERT_EQ(name_of_only_effect(rate), "rate-capacity");
  EXPECT_NEAR(rate.effects[0].parameters[0].value, 1.1, 0.01);
}

TEST(PlatformTracing, ABoardsHiddenPowerAndItsSupplyAreFound) {
  const Explanation hidden = explained(board({.static_W = 0.8}));
  ASSERT_EQ(name_of_only_effect(hidden), "static-power");
  EXPECT_NEAR(hidden.effects[0].parameters[0].value, 0.8, 0.05);
  const Explanation supply = explained(board({.efficiency = 0.85}));
  ASSERT_EQ(name_of_only_effect(supply), "supply-loss");
  EXPECT_NEAR(supply.effects[0].parameters[0].value, 0.85, 0.01);
}

// This board's governor is not the model's: what they differ in is often left over (`unexplained`), or taken up by a
// small second effect. But throttling is what leads whenever the recording counts as explained.
TEST(PlatformTracing, ThrottlingLeadsWheneverItIsExplained) {
  for (int recording = 0; recording < 6; ++recording) {
    const Explanation throttling = explained(board({.limit_C = 52}));
    EXPECT_NE(throttling.verdict, Verdict::nothing_missing);
    if (throttling.verdict != Verdict::explained) continue;
    EXPECT_EQ(throttling.effects.front().kind, "thermal-throttling");
  }
}

// It slows down while it is too warm and recovers more slowly, so that it swings about its limit by several degrees.
TEST(PlatformTracing, AGovernorThatSlowsAndRecoversInStepsIsFound) {
  const Explanation e = explained(board({.limit_C = 52, .slower_per_s = 0.012, .faster_per_s = 0.005}));
  ASSERT_EQ(name_of_only_effect(e), "thermal-throttling");
  ASSERT_EQ(e.effects[0].form, "steps");
  EXPECT_NEAR(e.effects[0].parameters[0].value, 52, 0.5);
  EXPECT_NEAR(e.effects[0].parameters[1].value, 0.012, 0.003);
  EXPECT_NEAR(e.effects[0].parameters[2].value, 0.005, 0.002);
  EXPECT_GT(e.before.rms, 3);
  EXPECT_LT(e.held_out->rms, 1.1);
}

TEST(PlatformTracing, RecordingsOfWhichNothingIsPredictedAreRefused) {
  Hardware hardware = board({});
  hardware.thermal_resistance_C_per_W.reset();
  for (HardwareTrial& trial : hardware.trials) trial.power_W.resize(0);
  const auto model = hardware_model(hardware);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().code, "experiment-invalid");
}

}  // namespace
}  // namespace glisson::closedloop
