// Meters found in a made-up system folder: what the kernel shows on a laptop, on a Jetson, on a server without rights.

#include "hardware/energy_meter.h"

#include <gmock/gmock.h>
#include <chrono>
#include <fstream>
#include <map>
#include <thread>

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

TEST(EnergyMeters, NonsenseInTheFilesIsNoMeter) {
  const SystemFolder system({{"class/powercap/intel-rapl:0/name", "package-0"},
                             {"class/powercap/intel-rapl:0/energy_uj", "a lot"},
                             {"class/powercap/intel-rapl:0/max_energy_range_uj", "nan"},
                             {"class/hwmon/hwmon0/name", "ina3221"},
                             {"class/hwmon/hwmon0/in1_input", ""},
                             {"class/hwmon/hwmon0/curr1_input", "3"}});
  EXPECT_TRUE(system.survey().meters.empty());
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
