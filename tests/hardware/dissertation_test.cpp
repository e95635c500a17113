// Chapter 6's findings, one by one, from table 6.2 and the assumptions that the device table states.
//
// Taken over as they stand: voltage, idle power, battery and how it is worn (table 6.2), 45 C, 18 C, 3 hours, 200
// products a frame, 10 x 10 problems with 1.65 to 165 mm3 a node. Assumed: the volumes of figure 6.4, every thermal
// figure, every time and energy of the kernel (the figures' curves are not in the text).

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>

#include "hardware/grid.h"
#include "hardware/power_trace.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

const std::vector<double> frame_rates{10, 15, 20, 25};  // what the dissertation calls video rate, and its steps

PlanRequest three_hours(double frames_per_s) {
  PlanRequest request;
  request.liver_volume_cm3 = 1500;
  request.accuracy_mm = 8;
  request.duration_h = 3;
  request.frames_per_s = frames_per_s;
  return request;
}

DeviceSurfaces surfaces_of(const char* id, double frames_per_s) {
  const auto devices = test::shipped_devices();
  return *surfaces_over(dissertation_grid(), test::device_named(devices, id), three_hours(frames_per_s));
}

DevicePlan answer_of(const char* id, double frames_per_s) {
  const auto devices = test::shipped_devices();
  const auto planned = plan(three_hours(frames_per_s), devices, test::dissertation_curve());
  return *std::find_if(planned->platforms.begin(), planned->platforms.end(),
                       [&](const DevicePlan& answer) { return answer.id == id; });
}

double highest(const GridSurface& surface) { return *std::max_element(surface.values.begin(), surface.values.end()); }
double lowest(const GridSurface& surface) { return *std::min_element(surface.values.begin(), surface.values.end()); }

TEST(Table62, BatteriesAllowWhatTheyAllowBeforeAnythingIsComputed) {
  const Headroom tx2 = answer_of("tx2-gpu", 10).idle;
  EXPECT_NEAR(tx2.allowed_W, 3.0, 1e-9);  // 9 Wh over 3 h
  EXPECT_NEAR(tx2.headroom_W, 0.2, 1e-9);
  const Headroom de10 = answer_of("de10-fpga", 10).idle;
  EXPECT_NEAR(de10.idle_h, 5.0 / 5.5, 1e-9);  // 0.9 h
  EXPECT_LT(de10.headroom_W, 0);
  for (const char* id : {"de5-fpga", "k40-gpu"}) {
    const Headroom back = answer_of(id, 10).idle;
    EXPECT_NEAR(back.allowed_W, 30.8, 1e-9);  // 92.4 Wh over 3 h
    EXPECT_NEAR(back.headroom_W, 0.8, 1e-9);
  }
}

TEST(Figure64, HundredProblems) {
  const ProblemGrid grid = dissertation_grid();
  EXPECT_EQ(grid.volumes_cm3.size() * grid.resolutions_mm3.size(), 100u);
  EXPECT_DOUBLE_EQ(grid.resolutions_mm3.front(), 1.65);
  EXPECT_DOUBLE_EQ(grid.resolutions_mm3.back(), 165);
}

// Ours: 0.55 mm at 1.65 mm3 and 3.4 mm at 161; the dissertation's text: 1 and 8 mm at 165. It names its load, a
// pneumoperitoneum, but not how large it is, and the error is in proportion to that; ours is the beam's own weight.
// That 5 mm lie within the curve is its finding and not ours.
TEST(Figure65, ErrorGrowsSteadilyWithTheNodes) {
  const ConvergenceCurve curve = test::shipped_curve();
  EXPECT_LT(curve.points.front().error_mm, 1);
  EXPECT_GT(curve.points.back().error_mm, 3);
  for (std::size_t p = 1; p < curve.points.size(); ++p) {
    EXPECT_GT(curve.points[p].error_mm, curve.points[p - 1].error_mm);
  }
  EXPECT_NEAR(*resolution_for_accuracy_mm3(test::dissertation_curve(), 5), 58, 1);
}

// A clamp's trace taken apart: idle subtracted, runs told apart, each run's mean power.
TEST(Figure66, RunsStandOutOfThePowerTrace) {
  PowerTrace trace;
  trace.sample_interval_s = 0.01;
  const double run_W[] = {4.0, 4.6, 5.3};  // above 2.8 W idle, as problems grow
  for (int i = 0; i < 1400; ++i) {
    const int period = i / 400;
    const bool running = i % 400 >= 200 && period < 3;
    trace.time_s.push_back(0.01 * i);
    trace.power_W.push_back(2.8 + (running ? run_W[period] - 2.8 : 0) + 0.02 * ((i * 7919) % 11 - 5));
    trace.clipped.push_back(false);
  }
  const auto runs = find_runs(trace);
  ASSERT_TRUE(runs) << runs.error().message();
  EXPECT_NEAR(runs->idle_W, 2.8, 0.02);
  ASSERT_EQ(runs->runs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    // An edge may be off by half the smoothing window, 0.06 s of 2 s.
    const double above_idle_W = run_W[i] - 2.8;
    EXPECT_NEAR(runs->runs[i].mean_W, run_W[i], 0.06 * above_idle_W);
    EXPECT_NEAR(runs->runs[i].joules_above_idle, 2 * above_idle_W, 0.12 * above_idle_W * 2);
  }
}

TEST(Figure67, PowerRisesWithTheFrameRateAndTheProblem) {
  for (const char* id : {"de5-fpga", "k40-gpu", "de10-fpga", "tx2-gpu"}) {
    const DeviceSurfaces slow = surfaces_of(id, 10);
    const DeviceSurfaces fast = surfaces_of(id, 25);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_GE(fast.power_W.values[i], slow.power_W.values[i]) << id;
    EXPECT_LT(slow.power_W.at(0, 9), slow.power_W.at(9, 0)) << id;  // least and most nodes
  }
}

TEST(Figure68, EnergyOfAProductRisesSteeplyWithTheNodes) {
  for (const char* id : {"de5-fpga", "k40-gpu", "de10-fpga", "tx2-gpu"}) {
    const DeviceSurfaces surfaces = surfaces_of(id, 10);
    const double nodes = highest(surfaces.nodes) / lowest(surfaces.nodes);
    const double energy = highest(surfaces.frame_joules) / lowest(surfaces.frame_joules);
    // 300 times the nodes; an order of magnitude in energy is the least that one would call steep.
    EXPECT_NEAR(nodes, 300, 1);
    EXPECT_GT(energy, 10) << id;
  }
}

TEST(Section65, HeadMountedFpgaCannotLastThreeHours) {
  const DeviceSurfaces surfaces = surfaces_of("de10-fpga", 10);
  EXPECT_LT(highest(surfaces.battery_h), 1);
  EXPECT_EQ(highest(surfaces.fps), 0);
}

TEST(Section65, BackMountedDevicesStayCoolAtAllFrameRates) {
  for (const char* id : {"de5-fpga", "k40-gpu"}) {
    for (const double fps : frame_rates) EXPECT_LE(highest(surfaces_of(id, fps).temperature_C), 45) << id;
  }
}

TEST(Figure69ab, BothHeadMountedDevicesOverheatInSomeCasesOnly) {
  for (const char* id : {"de10-fpga", "tx2-gpu"}) {
    const GridSurface temperature_C = surfaces_of(id, 25).temperature_C;
    EXPECT_GT(highest(temperature_C), 45) << id;
    EXPECT_LT(lowest(temperature_C), 45) << id;
  }
}

// Waves and memory on the chip that a problem fills or just does not: shown where the devices run without pause (240
// frames a second asked for), since pauses even them out. At 25 the model's hot spots are a hundredth of a degree; how
// large the dissertation's were is not in its text.
TEST(Figure69ab, DetailsOfTheKernelMakeHotSpots) {
  const auto devices = test::shipped_devices();
  for (const char* id : {"de10-fpga", "tx2-gpu"}) {
    EXPECT_FALSE(hot_spots(surfaces_of(id, 240).temperature_C, 0.1).empty()) << id;
    Device smooth = test::device_named(devices, id);
    smooth.kernel.tile_nodes.value = 1;
    smooth.kernel.fast_memory_MB.value = 0;
    EXPECT_TRUE(hot_spots(surfaces_over(dissertation_grid(), smooth, three_hours(240))->temperature_C, 1e-9).empty());
  }
}

TEST(Section65, HeadsetGpuBeatsHeadsetFpga) {
  const GridSurface gpu = surfaces_of("tx2-gpu", 10).fps;
  const GridSurface fpga = surfaces_of("de10-fpga", 10).fps;
  for (std::size_t i = 0; i < 100; ++i) EXPECT_GT(gpu.values[i], fpga.values[i]);
}

TEST(Section65, BackMountedGpuIsInferiorToBackMountedFpga) {
  const GridSurface gpu = surfaces_of("k40-gpu", 10).fps;
  const GridSurface fpga = surfaces_of("de5-fpga", 10).fps;
  for (std::size_t i = 0; i < 100; ++i) EXPECT_GT(fpga.values[i], gpu.values[i]);
}

TEST(Figure69cd, FrameRatesForThreeHoursAreToBeHadOnPartOfTheGrid) {
  for (const char* id : {"de5-fpga", "tx2-gpu"}) {
    const GridSurface fps = surfaces_of(id, 10).fps_by_energy;
    EXPECT_FALSE(contour(fps, 10).empty()) << id;
    EXPECT_GE(highest(fps), 10) << id;
    EXPECT_LT(lowest(fps), 10) << id;
  }
}

// Why the default block couples one node: with the cube of 27, not one of the 100 problems would have been left a
// frame rate of 10 by the batteries, and figures 6.9c and 6.9d would have been empty.
TEST(Figure69cd, BlocksOf27NodesWouldHaveLeftNoFrameRates) {
  const auto devices = test::shipped_devices();
  PlanRequest coupled = three_hours(10);
  coupled.workload.nodes_in_domain = 27;
  for (const char* id : {"de5-fpga", "tx2-gpu"}) {
    const auto surfaces = surfaces_over(dissertation_grid(), test::device_named(devices, id), coupled);
    EXPECT_LT(highest(surfaces->fps), 10) << id;
  }
}

}  // namespace
}  // namespace glisson::hardware
