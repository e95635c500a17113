// glisson-cli platform: the surgeon's question answered, a recording made into a device, and that device planned with.

#include <gmock/gmock.h>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "answer.h"
#include "base/files.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

using testing::HasSubstr;

Json platform_answer(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "platform");
  return answer(arguments);
}

const Json& platform_named(const Json& document, const std::string& id) {
  for (const Json& platform : document.at("platforms")) {
    if (platform.at("id") == id) return platform;
  }
  throw std::runtime_error("no platform " + id);
}

TEST(PlatformPlan, AnswersInTheContractsWords) {
  const Json plan =
      platform_answer({"plan", "--volume-cm3", "1000", "--accuracy-mm", "5", "--hours", "3", "--fps", "10"});
  ASSERT_GE(plan.at("platforms").size(), 4u);
  for (const Json& platform : plan.at("platforms")) {
    for (const char* key : {"id", "worn", "feasible", "fps", "battery_h", "temperature_C", "reasons", "idle"})
      EXPECT_TRUE(platform.contains(key)) << key;
    EXPECT_EQ(platform.at("feasible").get<bool>(), platform.at("reasons").empty());
  }
  const Json& fpga = platform_named(plan, "de10-fpga");
  EXPECT_FALSE(fpga.at("feasible").get<bool>());
  EXPECT_THAT(fpga.at("reasons")[0].get<std::string>(), HasSubstr("draws 5.5 W when idle"));
  ASSERT_TRUE(plan.at("recommended").is_string());
  EXPECT_TRUE(platform_named(plan, plan.at("recommended")).at("feasible").get<bool>());
}

TEST(PlatformPlan, SofterTissueIsMoreWork) {
  const auto nodes = [](const std::string& stiffness_kPa) {
    return platform_answer({"plan", "--volume-cm3", "1000", "--accuracy-mm", "5", "--stiffness-kPa", stiffness_kPa})
        .at("workload")
        .at("nodes")
        .get<double>();
  };
  EXPECT_GT(nodes("6"), nodes("12"));
}

TEST(PlatformLearn, WhatExplainFoundIsPlannedWith) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "model.json").string();
  ASSERT_TRUE(write_text_file(model, R"({"format": "glisson-closedloop-model/1", "kind": "platform",
      "verdict": "explained", "learnt_from": "tx2.json",
      "effects": [{"kind": "static-power", "parameters": {"static_W": 1.17}}]})"));
  const std::string out = (folder.path() / "learnt.json").string();
  const Json learnt = platform_answer({"learn", "--device", "tx2-gpu", "--model", model, "--out", out});
  EXPECT_NEAR(learnt.at("changed").at("idle_W").at("after").get<double>(), 2.8 + 1.17, 1e-9);
  const Json list = platform_answer({"list", "--devices", out});
  EXPECT_EQ(platform_named(list, "tx2-gpu-learnt").at("figures").at("idle_W").at("source"), "measured");
  EXPECT_EQ(glisson_cli({"platform", "learn", "--device", "abacus", "--model", model, "--out", out}).exit_code, 1);
}

TEST(PlatformPlan, NothingThatHoldsIsNullAndNoError) {
  const Json plan =
      platform_answer({"plan", "--volume-cm3", "2700", "--accuracy-mm", "1", "--hours", "24", "--fps", "60"});
  EXPECT_TRUE(plan.at("recommended").is_null());
}

TEST(PlatformPlan, IdleComesFirstForPeopleToo) {
  const Finished plan = glisson_cli({"platform", "plan", "--volume-cm3", "1500", "--accuracy-mm", "8"});
  EXPECT_LT(plan.out.find("Idle first"), plan.out.find("frames a second (or"));
}

TEST(PlatformPlan, BadQuestionsAndTablesAreRefused) {
  const auto refused = [](std::vector<std::string> changed) {
    std::vector<std::string> arguments{"platform", "plan", "--volume-cm3", "1000", "--accuracy-mm", "5", "--json"};
    arguments.insert(arguments.end(), changed.begin(), changed.end());
    const Finished finished = glisson_cli(arguments);
    EXPECT_EQ(finished.exit_code, 1);
    return finished.json().at("error").at("code").get<std::string>();
  };
  EXPECT_EQ(refused({"--fps", "0"}), "request-invalid");
  EXPECT_EQ(refused({"--hours", "-1"}), "request-invalid");
  EXPECT_EQ(refused({"--domain-nodes", "5"}), "domain-invalid");
  EXPECT_EQ(refused({"--devices", "/no/such.json"}), "file-not-readable");
  EXPECT_EQ(glisson_cli({"platform", "plan", "--volume-cm3", "10000", "--accuracy-mm", "5"}).exit_code, 1);
  EXPECT_EQ(glisson_cli({"platform", "plan", "--volume-cm3", "1000"}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"platform"}).exit_code, 2);
}

TEST(PlatformList, ShowsWhereFiguresComeFrom) {
  const Json list = platform_answer({"list"});
  const Json& tx2 = platform_named(list, "tx2-gpu");
  EXPECT_EQ(tx2.at("figures").at("idle_W").at("source"), "dissertation");
  EXPECT_EQ(tx2.at("figures").at("thermal_resistance_C_per_W").at("source"), "assumed");
  EXPECT_THAT(tx2.at("assumed"), testing::Contains("kernel.active_W"));
}

TEST(PlatformGrid, HasTenByTenProblemsAndContours) {
  const Json grid = platform_answer({"grid", "--device", "tx2-gpu", "--hours", "3", "--fps", "10,25"});
  ASSERT_EQ(grid.at("at").size(), 2u);
  const Json& at_10 = grid.at("at")[0];
  EXPECT_EQ(at_10.at("temperature_C").size(), 10u);
  EXPECT_EQ(at_10.at("temperature_C")[0].size(), 10u);
  EXPECT_FALSE(at_10.at("contour_energy").empty());
  EXPECT_EQ(glisson_cli({"platform", "grid", "--device", "abacus"}).exit_code, 1);
}

TEST(PlatformGrid, DrawsTheFiguresOnAPageAndSaysHowHotHotSpotsAre) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "grid.html").string();
  const Json grid = platform_answer({"grid", "--device", "tx2-gpu", "--fps", "25,240", "--out", page});
  const auto text = read_text_file(page);
  ASSERT_TRUE(text);
  for (const char* figure : {"Figure 6.7", "Figure 6.8", "Figure 6.9"}) EXPECT_THAT(*text, testing::HasSubstr(figure));
  // They are there where the device runs without pause, and hardly where it waits between frames.
  EXPECT_GT(grid.at("at")[1].at("hottest_spot_C").get<double>(), 0.1);
  EXPECT_LT(grid.at("at")[0].at("hottest_spot_C").get<double>(), 0.1);
}

TEST(PlatformPlan, OfThisProgramsOwnTasksSaysHowSureItIs) {
  for (const char* task : {"rehearse", "rehearse-large-strain", "rehearse-meshfree", "guide", "match"}) {
    const Json plan = platform_answer({"plan", "--for", task, "--hours", "3", "--fps", "10"});
    EXPECT_EQ(plan.at("workload").at("task"), task);
    for (const Json& platform : plan.at("platforms")) {
      const double holds = platform.at("holds_probability").get<double>();
      EXPECT_GE(holds, 0);
      EXPECT_LE(holds, 1);
      EXPECT_LE(platform.at("fps_interval")[0], platform.at("fps_interval")[1]);
    }
  }
  EXPECT_EQ(glisson_cli({"platform", "plan", "--for", "juggle"}).exit_code, 1);
}

// Two runs of a made-up device, at 8 and 10 W over idling at 3 W, as a clamp of 10 A/V on 5 V would show them.
void write_recording(const std::filesystem::path& folder) {
  std::ofstream trace(folder / "scope.csv");
  trace << "t,clamp\n";
  for (int i = 0; i < 1200; ++i) {
    const double t = i * 0.01;
    const double power_W = t >= 2 && t < 5 ? 8 : t >= 7 && t < 10 ? 10 : 3;
    trace << t << ',' << power_W / 50 << '\n';
  }
  std::ofstream(folder / "log.csv") << "nodes,products\n6000,3000\n60000,300\n";
}

TEST(PlatformMeasure, RecordingBecomesADeviceThatCanBePlannedWith) {
  const TemporaryFolder folder;
  write_recording(folder.path());
  const std::string out = (folder.path() / "mine.json").string();
  const Json measured = platform_answer({"measure", "--out", out, "--id", "my-headset", "--worn", "head", "--trace",
                                         (folder.path() / "scope.csv").string(), "--channel", "clamp:10:5",
                                         "--time-column", "t", "--run-log", (folder.path() / "log.csv").string(),
                                         "--battery-mAh", "9000", "--battery-V", "7.2"});
  EXPECT_NEAR(measured.at("trace").at("idle_W").get<double>(), 3, 1e-6);
  ASSERT_EQ(measured.at("trace").at("runs").size(), 2u);
  // An edge may be off by half the smoothing window, 0.06 s of 3 s.
  EXPECT_NEAR(measured.at("points")[0].at("joules").get<double>(), 5 * 3 / 3000.0, 2e-4);
  const Json plan =
      platform_answer({"plan", "--volume-cm3", "1000", "--accuracy-mm", "20", "--fps", "1", "--devices", out});
  const Json& mine = platform_named(plan, "my-headset");
  EXPECT_EQ(mine.at("worn"), "head");
  EXPECT_NEAR(mine.at("fps_by_computing").get<double>(), 5, 0.2);  // 1 ms a product at 6000 nodes
}

// A processor's counter that grows by 20 W, shown as the kernel shows it.
TEST(PlatformMeasure, NamesItsMeterAndHowSureItIs) {
  const TemporaryFolder folder;
  const auto zone = folder.path() / "sys" / "class" / "powercap" / "intel-rapl:0";
  ASSERT_TRUE(write_text_file(zone / "name", "package-0\n"));
  ASSERT_TRUE(write_text_file(zone / "max_energy_range_uj", "262143328850\n"));
  const auto begin = std::chrono::steady_clock::now();
  const auto show = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return write_text_file(zone / "energy_uj", std::to_string(static_cast<long long>(20e6 * passed.count())) + "\n");
  };
  ASSERT_TRUE(show());
  std::atomic<bool> done = false;
  std::thread counter([&] {
    while (!done) {
      EXPECT_TRUE(show());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  const std::vector<std::string> arguments{
      "measure", "--out",           (folder.path() / "mine.json").string(), "--idle-s", "0.5", "--largest-MB",
      "1",       "--system-folder", (folder.path() / "sys").string()};
  std::vector<std::string> by_battery{"platform", "--json", "--threads", "1"};  // the counter's thread needs a core
  by_battery.insert(by_battery.end(), arguments.begin(), arguments.end());
  // A busy machine may keep the counter's thread waiting while the program measures.
  const auto was_kept_waiting = [](const Finished& measurement) {
    return measurement.out.find("meter-too-coarse") != std::string::npos ||
           (measurement.exit_code == 0 && std::abs(measurement.json().at("idle_W").get<double>() - 20) > 1);
  };
  Finished finished = glisson_cli(by_battery);
  for (int i = 0; i < 10 && was_kept_waiting(finished); ++i) finished = glisson_cli(by_battery);
  by_battery.insert(by_battery.end(), {"--meter", "battery"});
  const Finished refused = glisson_cli(by_battery);
  done = true;
  counter.join();
  if (finished.out.find("meter-too-coarse") != std::string::npos)
    GTEST_SKIP() << "other programs keep the counter from counting: " << finished.out;
  ASSERT_EQ(finished.exit_code, 0) << finished.err << finished.out;
  const Json measured = finished.json();
  EXPECT_EQ(measured.at("meter"), "RAPL (packages: 1, no memory)");
  EXPECT_NEAR(measured.at("idle_W").get<double>(), 20, 1);
  // 20 W over the millisecond in which the counter is renewed, at two ends, over half a second.
  EXPECT_NEAR(measured.at("idle_uncertain_W").get<double>(), 20 * 0.408e-3 / 0.5, 0.003);
  EXPECT_THAT(measured.at("remarks").dump(), HasSubstr("is renewed every 0.001 s"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.out, HasSubstr("No battery gauge"));
}

TEST(PlatformLearn, IdleAndActivePowerOfAnAnalysersLogArePlannedWith) {
  GLISSON_NEEDS_DATA("mlperf_edge_power");
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "learnt.json").string();
  const Json learnt = platform_answer({"learn", "--device", "odroid-n2-cpu", "--out", out, "--trace",
                                       (shared_data() / "mlperf_edge_power" / "v2.0" / "Krai" /
                                        "odroid-armnn-v21.11-neon" / "resnet50" / "singlestream" / "spl.txt")
                                           .string()});
  // The device table has its quietest tenth, 2.3 W, and 2.9 W above it: 5.2 W under load either way.
  const double idle_W = learnt.at("changed").at("idle_W").at("after");
  const double active_W = learnt.at("changed").at("kernel.active_W").at("after");
  EXPECT_NEAR(idle_W + active_W, 5.2, 0.15);
  const Json list = platform_answer({"list", "--devices", out});
  EXPECT_EQ(platform_named(list, "odroid-n2-cpu-learnt").at("figures").at("idle_W").at("source"), "measured");
  EXPECT_EQ(glisson_cli({"platform", "learn", "--device", "odroid-n2-cpu", "--out", out}).exit_code, 2);
}

TEST(PlatformCell, PredictsADischargeThatItHasNotSeen) {
  GLISSON_NEEDS_DATA("battery_samsung_30q");
  const auto file = [](const std::string& rate) {
    return (shared_data() / "battery_samsung_30q" / "S001" / ("Q30_S001_" + rate + ".csv")).string();
  };
  const Json cell = platform_answer({"cell", "--slow", file("C10"), "--discharge", file("1C"), file("2C"), "--predict",
                                     file("3C"), "--discharge-negative"});
  ASSERT_EQ(cell.at("predictions").size(), 1u);
  const Json& prediction = cell.at("predictions")[0];
  const double measured_s = prediction.at("measured").at("seconds");
  EXPECT_NEAR(prediction.at("predicted").at("seconds").get<double>(), measured_s, 0.02 * measured_s);
}

TEST(PlatformMeasure, BadRecordingsLeaveNothingBehind) {
  const TemporaryFolder folder;
  write_recording(folder.path());
  const std::string out = (folder.path() / "mine.json").string();
  const std::string trace = (folder.path() / "scope.csv").string();
  for (const char* channel : {"clamp:x:5", "volts:10:5", "clamp:0:5", ":::"}) {
    const Finished finished =
        glisson_cli({"platform", "measure", "--out", out, "--trace", trace, "--channel", channel});
    EXPECT_EQ(finished.exit_code, 1) << channel;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

}  // namespace
}  // namespace glisson::test
