// A machine measured and planned with; the machine is a made-up one whose time is known.

#include "hardware/measure.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/files.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

// Takes 200 us for every 1000 nodes of a product, by the clock.
class ClockworkKernel : public ProductKernel {
 public:
  explicit ClockworkKernel(std::size_t maximum_nodes) : maximum_nodes_(maximum_nodes) {}
  [[nodiscard]] std::string name() const override { return "clockwork"; }
  Result<void> prepare(std::size_t nodes) override {
    if (nodes > maximum_nodes_) return failure("batch-too-large", "Too large.");
    return {};
  }
  Result<void> run(std::size_t nodes, int times) override {
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(2e-7 * static_cast<double>(nodes) * times);
    std::this_thread::sleep_until(std::chrono::time_point_cast<std::chrono::nanoseconds>(end));
    return {};
  }

 private:
  std::size_t maximum_nodes_;
};

MeasureOptions small_grid() {
  MeasureOptions options;
  options.grid = {{1000, 2000}, {40, 100}};  // 10,000 to 50,000 nodes
  options.idle_s = 0.05;
  options.seconds_per_point = 0.05;
  options.bandwidth_array_bytes = 1 << 20;  // no test is about the memory of the machine it runs on
  return options;
}

std::vector<std::string> messages(const Measurement& measured) {
  std::vector<std::string> messages;
  for (const Sentence& remark : measured.remarks) messages.push_back(remark.message());
  return messages;
}

TEST(Measure, TimesTheKernelOverTheGrid) {
  ClockworkKernel kernel(1000000);
  const auto measured = measure(kernel, nullptr, {{"No meter.", {}}}, small_grid());
  ASSERT_TRUE(measured) << measured.error().message();
  ASSERT_EQ(measured->points.size(), 4u);
  for (const MeasuredPoint& point : measured->points) {
    // Never faster than it runs; a busy machine may wake the sleeper late by some milliseconds in each of ten.
    EXPECT_GE(point.seconds, 0.999 * 2e-7 * point.nodes);
    EXPECT_LE(point.seconds, 4 * 2e-7 * point.nodes);
    EXPECT_FALSE(point.joules);
    // The roofline: 9 + 3 + 3 numbers of 4 bytes and 18 operations a node, and what that is of the memory's bandwidth.
    EXPECT_EQ(point.bytes, 60 * point.nodes);
    EXPECT_EQ(point.flops, 18 * point.nodes);
    EXPECT_NEAR(point.share_of_bandwidth, point.bytes / point.seconds * 1e-9 / measured->bandwidth_GB_s, 1e-12);
    EXPECT_EQ(point.in_cache, point.bytes < static_cast<double>(largest_cache_bytes()));
  }
  EXPECT_GT(measured->bandwidth_GB_s, 0);
  EXPECT_THAT(messages(*measured), testing::Contains("No meter."));
  EXPECT_THAT(messages(*measured), testing::Contains(testing::HasSubstr("are assumed")));
}

TEST(Measure, DeviceCanBePlannedWithAndShared) {
  const TemporaryFolder folder;
  ClockworkKernel kernel(1000000);
  MeasureOptions options = small_grid();
  options.device.idle_W = 5;
  options.device.active_W = 4;
  const auto measured = measure(kernel, nullptr, {}, options);
  ASSERT_TRUE(measured);
  ASSERT_TRUE(check(measured->device));
  ASSERT_TRUE(write_devices(folder.path() / "mine.json", {measured->device}));
  const auto devices = read_devices(folder.path() / "mine.json");
  ASSERT_TRUE(devices) << devices.error().message();
  PlanRequest request;
  request.liver_volume_cm3 = 1000;
  request.accuracy_mm = 8;
  const auto planned = plan(request, *devices, test::dissertation_curve());
  ASSERT_TRUE(planned);
  // 6061 nodes: below the measured 10,000, whose time then counts: 2 ms at least, 200 products a frame.
  EXPECT_LE(planned->platforms[0].fps_by_computing, 2.5);
  EXPECT_THAT(planned->platforms[0].assumed, testing::Contains("idle_W"));
  EXPECT_THAT(planned->platforms[0].assumed, testing::Not(testing::Contains("kernel.bandwidth_GB_s")));
}

TEST(Measure, ProblemsBeyondTheMemoryAreLeftOutAndSaid) {
  ClockworkKernel kernel(30000);
  const auto measured = measure(kernel, nullptr, {}, small_grid());
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->points.size(), 3u);
  EXPECT_THAT(messages(*measured), testing::Contains(testing::HasSubstr("1 of 4 problems")));
  ClockworkKernel none(10);
  EXPECT_EQ(measure(none, nullptr, {}, small_grid()).error().code, "batch-too-large");
}

// A board with a sensor that shows 5 W until the kernel runs, then 9.
class SensedBoard : public ClockworkKernel {
 public:
  SensedBoard() : ClockworkKernel(1000000) {
    std::filesystem::create_directories(sensor_);
    std::ofstream(sensor_ / "name") << "ina226\n";
    show_W(5);
  }
  Result<void> run(std::size_t nodes, int times) override {
    show_W(9);
    return ClockworkKernel::run(nodes, times);
  }
  [[nodiscard]] EnergyMeter meter() const { return survey_meters(system_.path()).meters.at(0); }

 private:
  void show_W(double power_W) const {
    EXPECT_TRUE(write_text_file(sensor_ / "power1_input", std::to_string(static_cast<long>(power_W * 1e6))));
  }
  TemporaryFolder system_;
  std::filesystem::path sensor_ = system_.path() / "class" / "hwmon" / "hwmon0";
};

TEST(Measure, MeterGivesIdlePowerAndEnergyAboveIt) {
  SensedBoard board;
  MeasureOptions options = small_grid();
  options.grid = {{1000, 1000.1}, {50, 100}};
  const EnergyMeter meter = board.meter();
  const auto measured = measure(board, &meter, {}, options);
  ASSERT_TRUE(measured) << measured.error().message();
  EXPECT_NEAR(measured->device.idle_W.value, 5, 1e-6);
  EXPECT_EQ(measured->device.idle_W.source, Source::measured);
  EXPECT_EQ(measured->device.kernel.active_W.source, Source::measured);
  for (const MeasuredPoint& point : measured->points) {
    ASSERT_TRUE(point.joules);
    EXPECT_GE(*point.joules / point.seconds, 3.99);  // 4 W; more where the fastest batch was faster than the mean
  }
  // Idle power was one reading, so that nothing says how sure it is; nothing is made up.
  EXPECT_FALSE(measured->idle_uncertain_W);
  EXPECT_THAT(messages(*measured), testing::Contains(testing::HasSubstr("how sure it is cannot be told")));
}

TEST(Measure, SlowMeterIsAskedAboutSomeProblemsOnly) {
  SensedBoard board;
  MeasureOptions options = small_grid();
  options.longest_metering_s = 1;  // the sensor needs half a second a problem, and there are four
  const EnergyMeter meter = board.meter();
  const auto measured = measure(board, &meter, {}, options);
  ASSERT_TRUE(measured) << measured.error().message();
  EXPECT_EQ(measured->points.size(), 4u);
  EXPECT_EQ(std::count_if(measured->points.begin(), measured->points.end(),
                          [](const MeasuredPoint& point) { return point.joules.has_value(); }),
            2);
}

TEST(Measure, RecordingAndItsLogMakeADeviceWithoutRunningAnything) {
  TraceRuns runs;
  runs.idle_W = 3;
  runs.runs = {{0, 2, 8, 3, 10, 0, false}, {3, 5, 10, 3, 14, 0, false}};
  const auto measured = measurement_from(runs, {{10000, 1000}, {40000, 500}}, small_grid());
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->device.idle_W.value, 3);
  EXPECT_EQ(measured->device.idle_W.source, Source::measured);
  ASSERT_EQ(measured->device.kernel.measured.size(), 2u);
  EXPECT_NEAR(measured->device.kernel.measured[0].seconds, 2e-3, 1e-12);
  EXPECT_NEAR(*measured->device.kernel.measured[1].joules, 14.0 / 500, 1e-12);
  EXPECT_TRUE(check(measured->device));
}

}  // namespace
}  // namespace glisson::hardware
