// The device table: what ships is sound, what people write is checked, what is written reads back.

#include "hardware/device_file.h"

#include <gmock/gmock.h>
#include <functional>

#include "base/files.h"
#include "base/json.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

using test::devices_file;
using test::shipped_devices;

Result<std::vector<Device>> read_changed(const std::function<void(Json& devices)>& change) {
  const TemporaryFolder folder;
  Json document = *read_json_file(devices_file());
  change(document["devices"]);
  EXPECT_TRUE(write_text_file(folder.path() / "devices.json", document.dump()));
  return read_devices(folder.path() / "devices.json");
}

std::string code_of(const Result<std::vector<Device>>& result) { return result ? "read" : result.error().code; }

TEST(DeviceFile, ShippedTableHoldsTheFourOfTable62AsStated) {
  struct Row {
    const char* id;
    Worn worn;
    double voltage_V, idle_W, capacity_mAh;
  };
  const auto devices = shipped_devices();
  for (const Row& row : {Row{"de5-fpga", Worn::back, 12, 30, 7700}, Row{"k40-gpu", Worn::back, 12, 30, 7700},
                         Row{"de10-fpga", Worn::head, 5, 5.5, 1000}, Row{"tx2-gpu", Worn::head, 9, 2.8, 1000}}) {
    const Device& device = test::device_named(devices, row.id);
    EXPECT_EQ(device.worn, row.worn);
    EXPECT_EQ(device.battery.voltage_V.value, row.voltage_V);
    EXPECT_EQ(device.idle_W.value, row.idle_W);
    EXPECT_EQ(device.battery.capacity_mAh.value, row.capacity_mAh);
    for (const Figure* figure : {&device.battery.voltage_V, &device.idle_W, &device.battery.capacity_mAh})
      EXPECT_EQ(figure->source, Source::dissertation) << row.id;
  }
}

TEST(DeviceFile, ShippedTableHasTodaysClassesAndEveryWayToWearThem) {
  const auto devices = shipped_devices();
  for (const char* id : {"agx-xavier-cpu", "xavier-nx-gpu", "orin-nano-head", "orin-nx-gpu", "agx-orin-gpu",
                         "raspberry-pi-4", "raspberry-pi-5", "laptop"}) {
    EXPECT_FALSE(test::device_named(devices, id).name.empty());
  }
  for (const Worn worn : {Worn::head, Worn::belt, Worn::back}) {
    EXPECT_TRUE(std::any_of(devices.begin(), devices.end(), [&](const Device& device) { return device.worn == worn; }));
  }
}

TEST(DeviceFile, AssumedFiguresAreSaidToBe) {
  const auto devices = shipped_devices();
  const auto assumed = assumed_figures(test::device_named(devices, "tx2-gpu"));
  EXPECT_THAT(assumed, testing::Contains("thermal_resistance_C_per_W"));
  EXPECT_THAT(assumed, testing::Contains("kernel.energy_nJ_per_byte"));
  EXPECT_THAT(assumed, testing::Not(testing::Contains("idle_W")));
  EXPECT_THAT(assumed, testing::Not(testing::Contains("battery.capacity_mAh")));
}

TEST(DeviceFile, WhatIsWrittenReadsBack) {
  const TemporaryFolder folder;
  auto devices = shipped_devices();
  devices[0].kernel.measured = {{1000, 1e-5, 2e-4}, {20000, 1.5e-4, std::nullopt}};
  devices[0].kernel.measured_nodes_in_domain = 27;
  ASSERT_TRUE(write_devices(folder.path() / "mine.json", devices));
  const auto again = read_devices(folder.path() / "mine.json");
  ASSERT_TRUE(again) << again.error().message();
  ASSERT_EQ(again->size(), devices.size());
  ASSERT_TRUE(write_devices(folder.path() / "again.json", *again));
  EXPECT_EQ(*read_text_file(folder.path() / "mine.json"), *read_text_file(folder.path() / "again.json"));
  ASSERT_EQ((*again)[0].kernel.measured.size(), 2u);
  EXPECT_EQ((*again)[0].kernel.measured[0].joules, 2e-4);
  EXPECT_FALSE((*again)[0].kernel.measured[1].joules.has_value());
  EXPECT_EQ((*again)[0].kernel.measured_nodes_in_domain, 27);
}

TEST(DeviceFile, DeviceWithoutBatteryIsRefused) {
  const auto refused = read_changed([](Json& devices) { devices[2].erase("battery"); });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "key-missing");
  EXPECT_THAT(refused.error().message(),
              testing::AllOf(testing::HasSubstr("de10-fpga"), testing::HasSubstr("battery")));
}

TEST(DeviceFile, NegativeResistanceIsRefusedWithItsLimits) {
  const auto refused = read_changed([](Json& devices) { devices[3]["thermal_resistance_C_per_W"]["value"] = -3.4; });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "figure-out-of-range");
  EXPECT_THAT(refused.error().message(), testing::AllOf(testing::HasSubstr("tx2-gpu"), testing::HasSubstr("-3.4")));
  EXPECT_FALSE(read_changed([](Json& devices) {
    devices[3]["battery"]["internal_resistance_ohm"] = {{"value", -0.1}, {"source", "assumed"}, {"note", "x"}};
  }));
}

TEST(DeviceFile, HostileContentIsRefusedNotBelieved) {
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices = "all of them"; })), "devices-missing");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices = Json::array(); })), "devices-missing");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0] = 7; })), "json-not-an-object");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[1]["id"] = "de5-fpga"; })), "device-twice");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["id"] = "../etc"; })), "device-id-invalid");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["name"] = std::string(100000, 'x'); })),
            "text-invalid");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["worn"] = "pocket"; })), "worn-unknown");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["idle_W"] = 30; })), "key-missing");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["idle_W"]["value"] = "30"; })), "key-missing");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["idle_W"]["source"] = "hearsay"; })), "source-unknown");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["idle_W"]["vlaue"] = 1; })), "json-unknown-key");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["kernel"] = Json::array(); })), "json-not-an-object");
  EXPECT_EQ(code_of(read_changed([](Json& devices) { devices[0]["battery"] = nullptr; })), "json-not-an-object");
  EXPECT_EQ(code_of(read_changed([](Json& devices) {
              devices[0]["kernel"]["measured"] = {{"nodes_in_domain", 1},
                                                  {"points",
                                                   {{{"nodes", 10}, {"seconds", 1}},  //
                                                    {{"nodes", 5}, {"seconds", 1}}}}};
            })),
            "device-invalid");
}

TEST(DeviceFile, AnotherFormatIsRefused) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "x.json", R"({"format": "glisson-case/1"})"));
  EXPECT_EQ(code_of(read_devices(folder.path() / "x.json")), "format-unknown");
  EXPECT_EQ(code_of(read_devices(folder.path() / "absent.json")), "file-not-readable");
}

}  // namespace
}  // namespace glisson::hardware
