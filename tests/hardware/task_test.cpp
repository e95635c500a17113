// What the product does as a workload, and how sure an answer is.

#include "hardware/task.h"

#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "hardware/plan.h"
#include "hardware/uncertainty.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

std::vector<Task> shipped_tasks() { return read_tasks(test::devices_file().parent_path() / "tasks.json").value(); }

PlanRequest request_for(const Task& task) {
  PlanRequest request;
  request.task = task;
  return request;
}

Device all_figures(Device device, Source source) {
  for (Figure* figure : {&device.idle_W, &device.thermal_resistance_C_per_W, &device.thermal_time_constant_s,
                         &device.battery.capacity_mAh, &device.battery.voltage_V, &device.kernel.bandwidth_GB_s,
                         &device.kernel.peak_GFLOPS, &device.kernel.fast_bandwidth_GB_s, &device.kernel.active_W,
                         &device.kernel.energy_nJ_per_byte, &device.kernel.launch_us}) {
    figure->source = source;
  }
  return device;
}

TEST(Task, TakesAsLongWhereMemoryGivesAsMuchAndTwiceAsLongWhereItGivesHalf) {
  Task task{"rehearse", "a frame", 3e9, 0, 0.1, Source::measured, "30 GB/s"};
  Device device = test::device_named(test::shipped_devices(), "tx2-gpu");
  device.kernel.fast_memory_MB.value = 0;
  device.kernel.tile_nodes.value = 1;
  device.kernel.launch_us.value = 0;
  device.kernel.bandwidth_GB_s.value = 30;
  EXPECT_NEAR(fastest_frames_per_s(device, workload_of(task)), 10, 1e-9);
  device.kernel.bandwidth_GB_s.value = 15;
  EXPECT_NEAR(fastest_frames_per_s(device, workload_of(task)), 5, 1e-9);
  task = {"match", "a registration", 0, 5e9, 0, Source::computed, "counted"};
  device.kernel.peak_GFLOPS.value = 100;
  EXPECT_NEAR(fastest_frames_per_s(device, workload_of(task)), 20, 1e-6);
}

// Block products that were timed on a device say nothing of another kind of work.
TEST(Task, IsNotReadOffTimedBlockProducts) {
  const Task task{"rehearse", "a frame", 3e9, 0, 0.1, Source::measured, "30 GB/s"};
  Device device = test::device_named(test::shipped_devices(), "tx2-gpu");
  const double before = fastest_frames_per_s(device, workload_of(task));
  device.kernel.measured = {{1000, 1.0, {}}, {2000, 2.0, {}}};
  EXPECT_EQ(fastest_frames_per_s(device, workload_of(task)), before);
}

TEST(Task, ShippedOnesAreReadWrittenAndPlannedWith) {
  const auto tasks = shipped_tasks();
  const TemporaryFolder folder;
  ASSERT_TRUE(write_tasks(folder.path() / "tasks.json", tasks));
  const auto again = read_tasks(folder.path() / "tasks.json");
  ASSERT_TRUE(again) << again.error().message();
  ASSERT_EQ(again->size(), tasks.size());
  std::vector<double> fps;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    EXPECT_EQ((*again)[i].id, tasks[i].id);
    EXPECT_EQ((*again)[i].bytes, tasks[i].bytes);
    const auto planned = plan(request_for(tasks[i]), test::shipped_devices(), test::shipped_curve());
    ASSERT_TRUE(planned) << planned.error().message();
    EXPECT_EQ(planned->platforms.size(), test::shipped_devices().size());
    EXPECT_THAT(planned->notes.front().message(), testing::HasSubstr(tasks[i].what));
    for (const DevicePlan& answer : planned->platforms) EXPECT_FALSE(answer.remedies.accuracy_mm) << answer.id;
  }
}

TEST(Task, WhatCannotBeATaskIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text) {
    const auto file = folder.path() / "tasks.json";
    EXPECT_TRUE(write_text_file(file, text));
    const auto tasks = read_tasks(file);
    return !tasks && !tasks.error().message().empty();
  };
  const std::string good =
      R"({"id": "a", "what": "b", "bytes": 1, "operations": 0, "seconds": 0, "source": "measured", "note": "c"})";
  EXPECT_FALSE(refused(R"({"format": "glisson-tasks/1", "tasks": [)" + good + "]}"));
  EXPECT_TRUE(refused(R"({"format": "glisson-tasks/1", "tasks": []})"));
  EXPECT_TRUE(refused(R"({"format": "glisson-tasks/2", "tasks": [)" + good + "]}"));
  EXPECT_TRUE(refused(R"({"format": "glisson-tasks/1", "tasks": [)" + good + "," + good + "]}"));
  EXPECT_TRUE(refused(R"({"format": "glisson-tasks/1", "tasks": [{"id": "a", "what": "b", "bytes": 0, "operations": 0,
      "seconds": 0, "source": "measured", "note": "c"}]})"));
  EXPECT_TRUE(refused("tasks"));
}

TEST(Certainty, FiguresAreDrawnAsWidelyAsTheirSourcesDeserve) {
  const Device device = test::device_named(test::shipped_devices(), "tx2-gpu");
  for (const Source source : {Source::measured, Source::computed, Source::assumed}) {
    const Device of = all_figures(device, source);
    double sum = 0, squares = 0;
    constexpr int draws = 2000;
    for (int draw = 0; draw < draws; ++draw) {
      const double log = std::log(drawn(of, static_cast<std::uint64_t>(draw)).idle_W.value / of.idle_W.value);
      sum += log / draws;
      squares += log * log / draws;
    }
    EXPECT_NEAR(sum, 0, 0.1 * relative_sd(source));
    EXPECT_NEAR(std::sqrt(squares), relative_sd(source), 0.05 * relative_sd(source));
  }
  EXPECT_EQ(drawn(device, 7).idle_W.value, drawn(device, 7).idle_W.value);
  EXPECT_EQ(drawn(device, 7).throttle_C.value, device.throttle_C.value);
}

TEST(Certainty, IsNearOneOrNoughtFarFromTheLimitAndBetweenAtIt) {
  Device device = all_figures(test::device_named(test::shipped_devices(), "odroid-n2-cpu"), Source::assumed);
  PlanRequest request = request_for(shipped_tasks().front());
  request.frames_per_s = 1;
  request.duration_h = 0.1;
  const Workload work = workload_of(*request.task);
  EXPECT_GT(certainty_of(device, work, request).holds, 0.95);
  request.duration_h = 48;
  EXPECT_LT(certainty_of(device, work, request).holds, 0.05);
  request.duration_h = 1;
  const DevicePlan answer = answer_for(device, work, request);
  request.frames_per_s = answer.fps;  // what it can just do
  const Certainty at_the_limit = certainty_of(device, work, request);
  EXPECT_GT(at_the_limit.holds, 0.2);
  EXPECT_LT(at_the_limit.holds, 0.8);
  EXPECT_LT(at_the_limit.fps_low, answer.fps);
  EXPECT_GT(at_the_limit.fps_high, answer.fps);
  // Measured figures leave less open.
  const Certainty measured = certainty_of(all_figures(device, Source::measured), work, request);
  EXPECT_LT(measured.fps_high - measured.fps_low, 0.5 * (at_the_limit.fps_high - at_the_limit.fps_low));
}

}  // namespace
}  // namespace glisson::hardware
