// Meters found in a made-up system folder: what the kernel shows on a laptop, on a Jetson, on a server without rights.

#include "hardware/energy_meter.h"

#include <gmock/gmock.h>
#include <unistd.h>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <thread>
#include <tuple>

#include "base/files.h"

namespace glisson::hardware {
namespace {

class SystemFolder {
 public:
  explicit SystemFolder(const std::map<std::string, std::string>& files) {
    for (const auto& [name, text] : files) set(name, text);
  }
  void set(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text << '\n';
  }
  [[nodiscard]] MeterSurvey survey() const { return survey_meters(folder_.path()); }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

Result<void> nothing() { return {}; }

std::vector<std::string> messages(const MeterSurvey& survey) {
  std::vector<std::string> messages;
  for (const Sentence& sentence : survey.missing) messages.push_back(sentence.message());
  return messages;
}

TEST(EnergyMeters, NoneThereSaysSoForEach) {
  const MeterSurvey survey = SystemFolder({}).survey();
  EXPECT_TRUE(survey.meters.empty());
  EXPECT_THAT(messages(survey), testing::ElementsAre(testing::HasSubstr("RAPL"), testing::HasSubstr("INA"),
                                                     testing::HasSubstr("battery")));
}

TEST(EnergyMeters, RaplCountsWholePackagesOnceAndWraps) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "262143000000"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "262143328850"},
                             {"class/powercap/intel-rapl:0:0/name", "core"},
                             {"class/powercap/intel-rapl:0:0/energy_uj", "5"},
                             {"class/powercap/intel-rapl:0:0/max_energy_range_uj", "9"},
                             {"class/powercap/intel-rapl:1/name", "package-1"},
                             {"class/powercap/intel-rapl:1/energy_uj", "1000000"},
                             {"class/powercap/intel-rapl:1/max_energy_range_uj", "262143328850"}});
  const MeterSurvey survey = system.survey();
  ASSERT_EQ(survey.meters.size(), 1u);
  EXPECT_EQ(survey.meters[0].kind, MeterKind::rapl);
  ASSERT_EQ(survey.meters[0].sources.size(), 2u);
  const auto use = energy_during(survey.meters[0], [&]() -> Result<void> {
    system.set("class/powercap/intel-rapl:0/energy_uj", "1671150");  // 328,850 to the wrap and 1,671,150 after it: 2 J
    system.set("class/powercap/intel-rapl:1/energy_uj", "4000000");  // 3 J
    return {};
  });
  ASSERT_TRUE(use);
  EXPECT_NEAR(use->joules, 5, 1e-9);
}

// A package does not contain its memory, but its cores; the same package by another way is not a second one.
TEST(EnergyMeters, RaplAddsMemoryOnceAndNoCores) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "0"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "1000000000"},
                             {"class/powercap/intel-rapl:0:0/name", "core"},
                             {"class/powercap/intel-rapl:0:0/energy_uj", "0"},
                             {"class/powercap/intel-rapl:0:0/max_energy_range_uj", "1000000000"},
                             {"class/powercap/intel-rapl:0:1/name", "dram"},
                             {"class/powercap/intel-rapl:0:1/energy_uj", "0"},
                             {"class/powercap/intel-rapl:0:1/max_energy_range_uj", "1000000000"},
                             {"class/powercap/intel-rapl:1/name", "psys"},
                             {"class/powercap/intel-rapl:1/energy_uj", "0"},
                             {"class/powercap/intel-rapl:1/max_energy_range_uj", "1000000000"},
                             {"class/powercap/intel-rapl-mmio:0/name", "package-0"},
                             {"class/powercap/intel-rapl-mmio:0/energy_uj", "0"},
                             {"class/powercap/intel-rapl-mmio:0/max_energy_range_uj", "1000000000"}});
  const EnergyMeter meter = system.survey().meters.at(0);
  EXPECT_EQ(meter.name, "RAPL (packages: 1, memories: 1)");
  const auto use = energy_during(meter, [&]() -> Result<void> {
    for (const char* zone : {"intel-rapl:0", "intel-rapl:0:0", "intel-rapl:1", "intel-rapl-mmio:0"})
      system.set(std::string("class/powercap/") + zone + "/energy_uj", "7000000");
    system.set("class/powercap/intel-rapl:0:1/energy_uj", "2000000");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return {};
  });
  ASSERT_TRUE(use);
  EXPECT_NEAR(use->joules, 9, 1e-9);
  // The counter is renewed every millisecond, and is read anywhere in one: sqrt(1/6) ms of power, of each of the two.
  const double seconds = use->seconds;
  EXPECT_NEAR(*use->uncertain_J, std::hypot(7 / seconds, 2 / seconds) * 0.408e-3, 1e-6);
}

TEST(EnergyMeters, CounterMayWrapManyTimes) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "0"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "1000000"}});
  const auto use = energy_during(system.survey().meters.at(0), [&]() -> Result<void> {
    for (const char* counter : {"600000", "200000", "800000", "400000", "0"}) {  // 0.6 J further each time
      system.set("class/powercap/intel-rapl:0/energy_uj", counter);
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
    }
    return {};
  });
  ASSERT_TRUE(use) << use.error().message();
  EXPECT_NEAR(use->joules, 3, 1e-9);
}

TEST(EnergyMeters, WhatOnlyRootMayReadIsSaidWithWhatToDo) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to become somebody who may not read";
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "5"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "1000000"}});
  namespace fs = std::filesystem;
  fs::permissions(system.path(), fs::perms::owner_all | fs::perms::group_all | fs::perms::others_all);
  fs::permissions(system.path() / "class/powercap/intel-rapl:0/energy_uj", fs::perms::owner_read);
  constexpr uid_t nobody = 65534;
  ASSERT_EQ(seteuid(nobody), 0);
  const MeterSurvey survey = system.survey();
  ASSERT_EQ(seteuid(0), 0);
  EXPECT_TRUE(survey.meters.empty());
  EXPECT_THAT(messages(survey), testing::Contains(testing::HasSubstr("run this once as root")));
}

TEST(EnergyMeters, CounterThatStandsStillTellsNothing) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "5"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "1000000"}});
  EXPECT_EQ(energy_during(system.survey().meters.at(0), nothing).error().code, "meter-too-coarse");
}

TEST(EnergyMeters, JetsonsBoardInputContainsItsOtherChannels) {
  const SystemFolder system({{"class/hwmon/hwmon0/name", "cpu_thermal"},
                             {"class/hwmon/hwmon3/name", "ina3221"},
                             {"class/hwmon/hwmon3/in1_label", "VDD_IN"},
                             {"class/hwmon/hwmon3/in1_input", "5000"},
                             {"class/hwmon/hwmon3/curr1_input", "800"},
                             {"class/hwmon/hwmon3/in2_label", "VDD_CPU_GPU_CV"},
                             {"class/hwmon/hwmon3/in2_input", "5000"},
                             {"class/hwmon/hwmon3/curr2_input", "300"}});
  const MeterSurvey survey = system.survey();
  ASSERT_EQ(survey.meters.size(), 1u);
  EXPECT_EQ(survey.meters[0].kind, MeterKind::ina);
  ASSERT_EQ(survey.meters[0].sources.size(), 1u);
  const auto use = energy_during(survey.meters[0], []() -> Result<void> {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return {};
  });
  ASSERT_TRUE(use);
  EXPECT_NEAR(use->mean_W(), 4, 1e-9);  // 5 V x 0.8 A
  EXPECT_GE(use->seconds, 0.1);
}

TEST(EnergyMeters, SensorThatGivesPowerIsReadAsItIs) {
  const SystemFolder system({{"class/hwmon/hwmon1/name", "ina226"}, {"class/hwmon/hwmon1/power1_input", "7250000"}});
  EXPECT_NEAR(energy_during(system.survey().meters.at(0), nothing)->mean_W(), 7.25, 1e-9);
}

TEST(EnergyMeters, BatteryCountsWhileDischargingOnly) {
  SystemFolder system({{"class/power_supply/AC/type", "Mains"},
                       {"class/power_supply/BAT0/type", "Battery"},
                       {"class/power_supply/BAT0/status", "Charging"},
                       {"class/power_supply/BAT0/voltage_now", "11600000"},
                       {"class/power_supply/BAT0/current_now", "-1000000"}});
  EXPECT_TRUE(system.survey().meters.empty());
  EXPECT_THAT(messages(system.survey()), testing::Contains(testing::HasSubstr("unplug")));
  system.set("class/power_supply/BAT0/status", "Discharging");
  ASSERT_EQ(system.survey().meters.size(), 1u);
  EXPECT_NEAR(energy_during(system.survey().meters[0], nothing)->mean_W(), 11.6, 1e-9);
}

std::map<std::string, std::string> battery(const std::map<std::string, std::string>& files) {
  std::map<std::string, std::string> all{{"class/power_supply/BAT0/type", "Battery"},
                                         {"class/power_supply/BAT0/status", "Discharging"}};
  for (const auto& [name, text] : files) all["class/power_supply/BAT0/" + name] = text;
  return all;
}

TEST(EnergyMeters, BatteryThatShowsNoPowerIsReadByWhatIsLeft) {
  // 200 mWh are 720 J; 50 mAh at 10 V are 1800 J.
  for (const auto& [files, moving, then, joules] :
       {std::tuple{battery({{"energy_now", "40000000"}, {"power_now", "0"}}), "energy_now", "39800000", 720.0},
        std::tuple{battery({{"charge_now", "4000000"}, {"voltage_now", "10000000"}}), "charge_now", "3950000",
                   1800.0}}) {
    const SystemFolder system(files);
    const EnergyMeter meter = system.survey().meters.at(0);
    EXPECT_THAT(meter.name, testing::HasSubstr("what is left"));
    const auto use = energy_during(meter, [&, name = moving, text = then]() -> Result<void> {
      system.set(std::string("class/power_supply/BAT0/") + name, text);
      return {};
    });
    ASSERT_TRUE(use) << use.error().message();
    EXPECT_NEAR(use->joules, joules, 1e-6);
    // One step was seen: it may have been due anywhere in the whole time, at either end.
    EXPECT_NEAR(*use->uncertain_J, 0.408 * joules, 1e-6 * joules);
  }
}

TEST(EnergyMeters, ScatterOfTheGaugesReadingsSaysHowSureTheMeanIs) {
  const SystemFolder system(battery({{"power_now", "9000000"}}));
  const EnergyMeter meter = system.survey().meters.at(0);
  const auto use = energy_during(meter, [&]() -> Result<void> {
    for (const char* power : {"11000000", "9000000", "11000000"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      system.set("class/power_supply/BAT0/power_now", power);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    return {};
  });
  ASSERT_TRUE(use);
  // 9, 11, 9 and 11 W: a standard deviation of 1.155 W, over the square root of four readings.
  EXPECT_NEAR(*use->uncertain_J / use->seconds, 1.155 / 2, 0.001);
  EXPECT_NEAR(*use->renewed_every_s, use->seconds / 3, 1e-9);
  EXPECT_NEAR(use->mean_W(), 10, 0.5);
  const auto single = energy_during(meter, nothing);
  ASSERT_TRUE(single);
  EXPECT_FALSE(single->uncertain_J);  // one reading: nobody can say
}

TEST(EnergyMeters, BatteryThatIsPluggedInMeanwhileIsRefused) {
  const SystemFolder system(battery({{"power_now", "9000000"}}));
  const auto use = energy_during(system.survey().meters.at(0), [&]() -> Result<void> {
    system.set("class/power_supply/BAT0/status", "Charging");
    return {};
  });
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().code, "meter-charging");
}

TEST(EnergyMeters, OfTwoBatteriesOneMayRestButNoneMayCharge) {
  auto files = battery({{"power_now", "9000000"}});
  files["class/power_supply/BAT1/type"] = "Battery";
  files["class/power_supply/BAT1/status"] = "Not charging";
  files["class/power_supply/BAT1/power_now"] = "4000000";
  files["class/power_supply/hidpp_battery_0/type"] = "Battery";  // a mouse's
  files["class/power_supply/hidpp_battery_0/scope"] = "Device";
  files["class/power_supply/hidpp_battery_0/status"] = "Charging";
  const SystemFolder system(files);
  EXPECT_NEAR(energy_during(system.survey().meters.at(0), nothing)->mean_W(), 9, 1e-9);
  system.set("class/power_supply/BAT1/status", "Charging");
  EXPECT_TRUE(system.survey().meters.empty());
}

TEST(EnergyMeters, NonsenseInTheFilesIsNoMeter) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "a lot"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "nan"},
                             {"class/hwmon/hwmon0/name", "ina3221"},
                             {"class/hwmon/hwmon0/in1_input", ""},
                             {"class/hwmon/hwmon0/curr1_input", "3"},
                             {"class/power_supply/BAT0/type", "Battery"},
                             {"class/power_supply/BAT0/status", "Discharging"},
                             {"class/power_supply/BAT0/power_now", "some"}});
  EXPECT_TRUE(system.survey().meters.empty());
  EXPECT_THAT(messages(system.survey()),
              testing::ElementsAre(testing::HasSubstr("hold no number"), testing::HasSubstr("INA"),
                                   testing::HasSubstr("neither power nor what is left")));
}

TEST(EnergyMeters, OneThatGoesAwayIsLost) {
  const SystemFolder system({{"class/hwmon/hwmon1/name", "ina226"}, {"class/hwmon/hwmon1/power1_input", "1000000"}});
  const EnergyMeter meter = system.survey().meters.at(0);
  const auto use = energy_during(meter, [&]() -> Result<void> {
    std::filesystem::remove(meter.sources[0].power_uW);
    return {};
  });
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().code, "meter-lost");
}

TEST(EnergyMeters, FailureOfTheWorkIsPassedOn) {
  const SystemFolder system({{"class/hwmon/hwmon1/name", "ina226"}, {"class/hwmon/hwmon1/power1_input", "1000000"}});
  const auto use = energy_during(system.survey().meters.at(0), []() -> Result<void> { return cancelled(); });
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().code, "cancelled");
}

}  // namespace
}  // namespace glisson::hardware
