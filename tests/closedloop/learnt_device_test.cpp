// From model.json to a device that can be planned with.

#include "closedloop/learnt_device.h"

#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "base/json.h"
#include "hardware/device_file.h"
#include "support/folders.h"

namespace glisson::closedloop {
namespace {

hardware::Device declared() {
  const auto devices =
      hardware::read_devices(glisson::test::source_folder() / "resources" / "devices" / "devices.json");
  for (const hardware::Device& device : devices.value()) {
    if (device.id == "tx2-gpu") return device;
  }
  throw std::runtime_error("no tx2-gpu");
}

class LearntDeviceTest : public testing::Test {
 protected:
  Result<LearntDevice> learn(const std::vector<Json>& effects, const char* verdict = "explained") {
    const Json model{{"format", "glisson-closedloop-model/1"},
                     {"kind", "platform"},
                     {"verdict", verdict},
                     {"learnt_from", "tx2.json"},
                     {"effects", effects}};
    EXPECT_TRUE(write_text_file(folder_.path() / "model.json", model.dump()));
    return learn_device(declared(), folder_.path() / "model.json");
  }
  static Json effect(const char* kind, const Json& parameters, const char* form = "") {
    Json json{{"kind", kind}, {"parameters", parameters}};
    if (*form != '\0') json["law"] = form;
    return json;
  }

  TemporaryFolder folder_;
};

TEST_F(LearntDeviceTest, EffectsBecomeMeasuredFigures) {
  const auto learnt =
      learn({effect("internal-resistance", {{"resistance_ohm", 0.3}}), effect("static-power", {{"static_W", 1.17}}),
             effect("supply-loss", {{"efficiency", 0.9}}), effect("thermal-throttling", {{"limit_C", 43}}),
             effect("self-heating", {{"coefficient_per_C", 0.006}}, "capacity"),
             effect("discharge-curve", {{"curve_V", {0.4, -1.2}}})});
  ASSERT_TRUE(learnt) << learnt.error().message();
  const hardware::Device& device = learnt->device;
  EXPECT_NEAR(device.battery.internal_resistance_ohm.value, 0.3, 1e-12);
  EXPECT_NEAR(device.idle_W.value, 2.8 + 1.17, 1e-12);
  EXPECT_NEAR(device.supply_efficiency.value, 0.9, 1e-12);
  EXPECT_NEAR(device.throttle_C.value, 43, 1e-12);
  EXPECT_NEAR(device.battery.capacity_per_C.value, 0.006, 1e-12);
  EXPECT_NEAR(device.battery.voltage_V.value, 9 + 0.4 - 0.6, 1e-12);  // the mean of 0.4 - 1.2 d
  EXPECT_EQ(device.idle_W.source, hardware::Source::measured);
  EXPECT_THAT(device.idle_W.note, testing::HasSubstr("tx2.json"));
  EXPECT_EQ(device.battery.capacity_mAh.source, hardware::Source::dissertation);  // nobody learnt anything about it
  EXPECT_EQ(learnt->changed.size(), 6u);
  EXPECT_TRUE(learnt->remarks.empty());
}

TEST_F(LearntDeviceTest, PeukertOfAnotherRatedTimeGivesTheSameChargeAtEveryCurrent) {
  constexpr double exponent = 1.12;
  const auto learnt = learn({effect("rate-capacity", {{"exponent", exponent}}, "rated-1h")});
  ASSERT_TRUE(learnt) << learnt.error().message();
  const hardware::Battery battery = battery_of(learnt->device);
  for (const double current_A : {1.5, 2.0, 3.0}) {
    const double by_one_hour_Ah = 1.0 * std::pow(1.0 / current_A, exponent - 1);  // 1 Ah, rated at 1 A
    const auto drained = hardware::drain(battery, current_A * battery.nominal_voltage_V);
    ASSERT_TRUE(drained);
    EXPECT_NEAR(drained->hours * current_A, by_one_hour_Ah, 1e-9);
  }
}

TEST_F(LearntDeviceTest, WhatAPlanCannotUseIsSaid) {
  const auto learnt = learn({effect("self-heating", {{"coefficient_per_C", 0.01}})}, "unexplained");
  ASSERT_TRUE(learnt) << learnt.error().message();
  EXPECT_TRUE(learnt->changed.empty());
  ASSERT_EQ(learnt->remarks.size(), 2u);
  EXPECT_THAT(learnt->remarks[0].message(), testing::HasSubstr("self-heating"));
  EXPECT_THAT(learnt->remarks[1].message(), testing::HasSubstr("no proof of a cause"));
}

TEST_F(LearntDeviceTest, ModelsOfOtherThingsAndImpossibleFiguresAreRefused) {
  EXPECT_EQ(learn({effect("static-power", {{"static_W", -5}})}).error().code, "device-invalid");  // -2.2 W idle
  EXPECT_EQ(learn({effect("static-power", Json::object())}).error().code, "model-invalid");
  ASSERT_TRUE(write_text_file(folder_.path() / "other.json",
                              R"({"format": "glisson-closedloop-model/1", "kind": "palpation", "effects": []})"));
  EXPECT_EQ(learn_device(declared(), folder_.path() / "other.json").error().code, "model-invalid");
  EXPECT_EQ(learn_device(declared(), folder_.path() / "absent.json").error().code, "file-not-readable");
}

}  // namespace
}  // namespace glisson::closedloop
