// The two small physical models: heat agrees with a stepped integration, a battery's energy is never made or lost.

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "hardware/battery.h"
#include "hardware/heat.h"

namespace glisson::hardware {
namespace {

const HeatModel headset{3.4, 500};

// The slow, obvious version: Euler steps of tau dT/dt = (ambient + R P) - T.
double stepped_temperature_C(const HeatModel& model, double start_C, double power_W, double ambient_C, double elapsed_s,
                             double step_s) {
  double temperature_C = start_C;
  for (double t = 0; t < elapsed_s - step_s / 2; t += step_s) {
    temperature_C += step_s / model.time_constant_s * (ambient_C + model.resistance_C_per_W * power_W - temperature_C);
  }
  return temperature_C;
}

TEST(Heat, ClosedFormAgreesWithSteppedIntegration) {
  // Euler's error after t is about step/(2 tau) x t/tau x exp(-t/tau) x 27 C: at most 27 x 0.05/1000/e = 5e-4 C.
  for (const double elapsed_s : {10.0, 500.0, 3600.0}) {
    EXPECT_NEAR(temperature_after_C(headset, 18, 8, 18, elapsed_s),
                stepped_temperature_C(headset, 18, 8, 18, elapsed_s, 0.05), 1e-3);
  }
}

TEST(Heat, StartsWhereItIsAndEndsAtTheSteadyState) {
  EXPECT_DOUBLE_EQ(temperature_after_C(headset, 30, 8, 18, 0), 30);
  EXPECT_NEAR(temperature_after_C(headset, 30, 8, 18, 1e6), 18 + 3.4 * 8, 1e-12);
}

TEST(Heat, TimeToReachIsTheInverseOfTheTemperature) {
  const double reached_s = time_to_reach_s(headset, 18, 10, 18, 45);
  EXPECT_NEAR(temperature_after_C(headset, 18, 10, 18, reached_s), 45, 1e-9);
  EXPECT_EQ(time_to_reach_s(headset, 18, 7, 18, 45), std::numeric_limits<double>::infinity());
  EXPECT_EQ(time_to_reach_s(headset, 46, 0, 18, 45), 0);
}

TEST(Heat, LargestPowerIsTheOneThatJustReachesTheLimit) {
  const double power_W = largest_power_W(headset, 18, 45, 600);
  EXPECT_NEAR(temperature_after_C(headset, 18, power_W, 18, 600), 45, 1e-9);
  EXPECT_EQ(largest_power_W(headset, 45, 45, 600), 0);
}

TEST(BatteryModel, DeclaredBatteryGivesAllItHolds) {
  const Battery backpack{7.7, 12};
  const auto drained = drain(backpack, 30);
  ASSERT_TRUE(drained);
  EXPECT_NEAR(drained->hours, 92.4 / 30, 1e-12);
  EXPECT_NEAR(drained->delivered_Wh, 92.4, 1e-12);
  EXPECT_NEAR(drained->left_Wh, 0, 1e-12);
}

TEST(BatteryModel, EnergyIsConservedWhateverTheEffects) {
  for (const double resistance_ohm : {0.0, 0.05, 0.3}) {
    for (const double exponent : {1.0, 1.05, 1.3}) {
      for (const double per_C : {0.0, 0.006}) {
        for (const double load_W : {0.1, 3.0, 12.0}) {
          for (const double battery_C : {-10.0, 18.0, 40.0}) {
            Battery battery{1.0, 9.0, resistance_ohm, exponent, 5, per_C};
            const auto drained = drain(battery, load_W, battery_C);
            ASSERT_TRUE(drained);
            EXPECT_NEAR(drained->delivered_Wh + drained->heat_Wh + drained->left_Wh, drained->stored_Wh, 1e-12);
            // 1e-12: rounding of a few operations on 9 Wh; nothing comes from nowhere.
            EXPECT_GE(drained->left_Wh, -1e-12);
            EXPECT_GE(drained->heat_Wh, 0);
            // The load's power is what the terminals give.
            const double terminal_V = battery.nominal_voltage_V - drained->current_A * resistance_ohm;
            EXPECT_NEAR(terminal_V * drained->current_A, load_W, 1e-12);
          }
        }
      }
    }
  }
}

TEST(BatteryModel, EachEffectShortensTheTime) {
  const Battery ideal{1.0, 9.0};
  const double hours = drain(ideal, 6)->hours;
  Battery worse = ideal;
  worse.internal_resistance_ohm = 0.2;
  EXPECT_LT(drain(worse, 6)->hours, hours);
  worse = ideal;
  worse.rate_exponent = 1.1;
  EXPECT_LT(drain(worse, 6)->hours, hours);
  worse = ideal;
  worse.capacity_per_C = 0.01;
  EXPECT_LT(drain(worse, 6, 18)->hours, hours);
  EXPECT_DOUBLE_EQ(drain(worse, 6, 35)->hours, hours);
}

TEST(BatteryModel, LargestLoadIsTheOneThatJustLasts) {
  const Battery battery{2.957, 7.06, 0.1, 1.05, 5, 0.004};
  const double load_W = largest_load_W(battery, 3, 18);
  EXPECT_NEAR(drain(battery, load_W, 18)->hours, 3, 1e-6);
  EXPECT_DOUBLE_EQ(largest_load_W({1, 9}, 3), 3.0);
}

TEST(BatteryModel, MoreThanTheResistanceLetsThroughIsRefused) {
  const Battery battery{1, 9, 1.0};
  EXPECT_TRUE(drain(battery, 20.25));  // V^2 / 4R
  const auto refused = drain(battery, 20.3);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "battery-overloaded");
}

TEST(BatteryModel, ImpossibleBatteriesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(check(Battery{1, 9}));
  EXPECT_FALSE(check(Battery{0, 9}));
  EXPECT_FALSE(check(Battery{-1, 9}));
  EXPECT_FALSE(check(Battery{nan, 9}));
  EXPECT_FALSE(check(Battery{1, 0}));
  EXPECT_FALSE(check(Battery{1, 9, -0.1}));
  EXPECT_FALSE(check(Battery{1, 9, 0, 0.9}));
  EXPECT_FALSE(check(Battery{1, 9, 0, 1, 0}));
  EXPECT_FALSE(check(Battery{1, 9, 0, 1, 5, -0.1}));
}

}  // namespace
}  // namespace glisson::hardware
