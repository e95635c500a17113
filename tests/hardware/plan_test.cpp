// The plan: what it answers, what it says of those that fail, and what it refuses.

#include "hardware/plan.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <limits>

#include "hardware/grid.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

PlanRequest question(double accuracy_mm, double duration_h, double frames_per_s) {
  PlanRequest request;
  request.liver_volume_cm3 = 1000;
  request.accuracy_mm = accuracy_mm;
  request.duration_h = duration_h;
  request.frames_per_s = frames_per_s;
  return request;
}

const DevicePlan& answer_for(const Plan& planned, const std::string& id) {
  return *std::find_if(planned.platforms.begin(), planned.platforms.end(),
                       [&](const DevicePlan& answer) { return answer.id == id; });
}

bool fails_by(const DevicePlan& answer, Constraint constraint) {
  return std::any_of(answer.reasons.begin(), answer.reasons.end(),
                     [&](const Reason& reason) { return reason.constraint == constraint; });
}

TEST(Plan, TheDissertationsQuestionOfFiveHours) {
  // "a 1000 cm3 liver, < 5 mm, 5 hours: would a backpack do? a head mounted one?" (section 6.1)
  const auto planned = plan(question(5, 5, 10), test::shipped_devices(), test::dissertation_curve());
  ASSERT_TRUE(planned);
  for (const char* id : {"de5-fpga", "k40-gpu", "de10-fpga", "tx2-gpu"}) {
    const DevicePlan& answer = answer_for(*planned, id);
    EXPECT_FALSE(answer.feasible) << id;
    EXPECT_TRUE(fails_by(answer, Constraint::idle_energy)) << id;  // 18.5 W against 30; 1.8 against 2.8; 1 against 5.5
    EXPECT_EQ(answer.fps, 0) << id;
  }
  // A larger battery alone would carry the others, not the headset FPGA, which overheats besides.
  for (const char* id : {"de5-fpga", "k40-gpu", "tx2-gpu"}) EXPECT_TRUE(answer_for(*planned, id).remedies.battery_Wh);
  EXPECT_TRUE(fails_by(answer_for(*planned, "de10-fpga"), Constraint::temperature));
  EXPECT_FALSE(answer_for(*planned, "de10-fpga").remedies.battery_Wh);
  EXPECT_THAT(answer_for(*planned, "tx2-gpu").reasons.front().sentence.message(),
              testing::AllOf(testing::HasSubstr("2.8 W"), testing::HasSubstr("1.8 W")));
}

TEST(Plan, RecommendsTheLeastObtrusiveThatHolds) {
  const auto devices = test::shipped_devices();
  const auto planned = plan(question(5, 5, 10), devices, test::dissertation_curve());
  ASSERT_TRUE(planned->recommended);
  const DevicePlan& chosen = answer_for(*planned, *planned->recommended);
  EXPECT_TRUE(chosen.feasible);
  for (const DevicePlan& answer : planned->platforms) {
    if (!answer.feasible) continue;
    EXPECT_GE(static_cast<int>(answer.worn), static_cast<int>(chosen.worn));
  }
}

TEST(Plan, FeasibleIsWhatEveryConstraintSays) {
  for (const double duration_h : {1.0, 3.0, 6.0, 12.0}) {
    for (const double fps : {10.0, 25.0, 60.0}) {
      for (const double accuracy_mm : {1.0, 3.0, 8.0}) {
        const auto planned =
            plan(question(accuracy_mm, duration_h, fps), test::shipped_devices(), test::dissertation_curve());
        ASSERT_TRUE(planned);
        bool some = false;
        for (const DevicePlan& answer : planned->platforms) {
          // The two ways to decide meet at equality, where rounding may turn either.
          if (std::abs(answer.fps / fps - 1) < 1e-9) continue;
          EXPECT_EQ(answer.feasible, answer.fps > fps) << answer.id;
          EXPECT_EQ(answer.feasible, answer.reasons.empty());
          some = some || answer.feasible;
        }
        EXPECT_EQ(planned->recommended.has_value(), some);
      }
    }
  }
}

TEST(Plan, EachRemedyAloneMakesThePlatformHold) {
  // A hair is given beyond each threshold: it was found by halving to 2^-50.
  constexpr double hair = 1e-6;
  const ConvergenceCurve curve = test::dissertation_curve();
  int tried = 0;
  for (const PlanRequest& request :
       {question(2, 5, 25), question(3, 2, 15), question(1, 3, 10), question(7, 3.05, 10)}) {
    const auto planned = plan(request, test::shipped_devices(), curve);
    for (const Device& device : test::shipped_devices()) {
      const DevicePlan& answer = answer_for(*planned, device.id);
      if (answer.feasible) continue;
      const auto holds = [&](const PlanRequest& changed_request, const Device& changed_device) {
        ++tried;
        return plan(changed_request, {changed_device}, curve)->platforms.front().feasible;
      };
      const Remedies& remedies = answer.remedies;
      PlanRequest asked = request;
      if (remedies.duration_h && *remedies.duration_h > 0.2) {
        asked.duration_h = *remedies.duration_h * (1 - hair);
        EXPECT_TRUE(holds(asked, device)) << device.id << " duration";
      }
      asked = request;
      if (remedies.frames_per_s && *remedies.frames_per_s > 0.2) {
        asked.frames_per_s = *remedies.frames_per_s * (1 - hair);
        EXPECT_TRUE(holds(asked, device)) << device.id << " frame rate";
      }
      asked = request;
      if (remedies.accuracy_mm) {
        asked.accuracy_mm = *remedies.accuracy_mm * (1 + hair);
        EXPECT_TRUE(holds(asked, device)) << device.id << " accuracy";
      }
      Device changed = device;
      if (remedies.battery_Wh) {
        changed.battery.capacity_mAh.value = *remedies.battery_Wh * (1 + hair) / device.battery.voltage_V.value * 1e3;
        EXPECT_TRUE(holds(request, changed)) << device.id << " battery";
      }
      changed = device;
      if (remedies.thermal_resistance_C_per_W) {
        changed.thermal_resistance_C_per_W.value = *remedies.thermal_resistance_C_per_W * (1 - hair);
        EXPECT_TRUE(holds(request, changed)) << device.id << " thermal resistance";
      }
    }
  }
  EXPECT_GT(tried, 40);
}

TEST(Plan, SmallHeadroomIsNotHidden) {
  const auto planned = plan(question(14, 3, 10), test::shipped_devices(), test::dissertation_curve());
  ASSERT_TRUE(answer_for(*planned, "tx2-gpu").feasible);
  std::string notes;
  for (const Sentence& note : planned->notes) notes += note.message() + "\n";
  EXPECT_THAT(notes, testing::HasSubstr("Jetson TX2 GPU on the head holds with next to no headroom"));
  EXPECT_THAT(notes, testing::HasSubstr("27 nodes moves 22 times as much"));
}

TEST(Plan, SupplyLossCountsAgainstTheBattery) {
  auto devices = test::shipped_devices();
  Device device = test::device_named(devices, "tx2-gpu");
  device.supply_efficiency.value = 0.5;
  const auto planned = plan(question(8, 1, 10), {device}, test::dissertation_curve());
  EXPECT_NEAR(planned->platforms.front().idle.idle_h, 9 / 5.6, 1e-9);
}

// A governor holds the surface where it is by computing less: what it costs is the frame rate, not the skin.
TEST(Plan, ThrottlingCostsFramesAndStaysCool) {
  Device device = test::device_named(test::shipped_devices(), "xavier-nx-gpu");
  const PlanRequest request = question(2, 2, 20);
  const auto free = plan(request, {device}, test::dissertation_curve());
  const double unbridled_C = free->platforms.front().temperature_C;
  ASSERT_TRUE(free->platforms.front().feasible);
  device.throttle_C.value = 30;
  ASSERT_GT(unbridled_C, device.throttle_C.value);
  const auto planned = plan(request, {device}, test::dissertation_curve());
  const DevicePlan& answer = planned->platforms.front();
  EXPECT_FALSE(answer.feasible);
  EXPECT_TRUE(fails_by(answer, Constraint::throttling));
  EXPECT_FALSE(fails_by(answer, Constraint::computing));
  EXPECT_NEAR(answer.temperature_C, device.throttle_C.value, 1e-6);
  EXPECT_GT(answer.fps, 0);
  EXPECT_LT(answer.fps, 20);
  EXPECT_GT(answer.battery_h, free->platforms.front().battery_h);  // what is not computed is not drawn
  ASSERT_TRUE(answer.remedies.thermal_resistance_C_per_W);
  device.thermal_resistance_C_per_W.value = *answer.remedies.thermal_resistance_C_per_W * (1 - 1e-6);
  EXPECT_TRUE(plan(request, {device}, test::dissertation_curve())->platforms.front().feasible);
}

TEST(Plan, SofterLiversAskForMoreNodes) {
  PlanRequest request = question(5, 3, 10);
  request.youngs_kPa = 12;
  const double nodes = plan(request, test::shipped_devices(), test::dissertation_curve())->workload.nodes;
  EXPECT_EQ(nodes, plan(question(5, 3, 10), test::shipped_devices(), test::dissertation_curve())->workload.nodes);
  request.youngs_kPa = 6;
  EXPECT_GT(plan(request, test::shipped_devices(), test::dissertation_curve())->workload.nodes, nodes);
  request.youngs_kPa = 0;
  EXPECT_EQ(plan(request, test::shipped_devices(), test::dissertation_curve()).error().code, "request-invalid");
}

TEST(Plan, ImpossibleQuestionsAreRefused) {
  const auto code = [](const PlanRequest& request) {
    const auto planned = plan(request, test::shipped_devices(), test::dissertation_curve());
    return planned ? std::string("planned") : planned.error().code;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(question(5, 3, 0)), "request-invalid");
  EXPECT_EQ(code(question(5, 3, -10)), "request-invalid");
  EXPECT_EQ(code(question(5, 3, nan)), "request-invalid");
  EXPECT_EQ(code(question(5, 0, 10)), "request-invalid");
  EXPECT_EQ(code(question(5, nan, 10)), "request-invalid");
  EXPECT_EQ(code(question(0.5, 3, 10)), "accuracy-not-reached");
  PlanRequest hot = question(5, 3, 10);
  hot.ambient_C = 50;
  EXPECT_EQ(code(hot), "request-invalid");
  PlanRequest litres = question(5, 3, 10);
  litres.liver_volume_cm3 = 10000;
  EXPECT_EQ(code(litres), "volume-not-a-liver");
}

// Measured points take the place of the model, for the blocks that they were measured with and no others.
TEST(ProductCost, MeasuredPointsWin) {
  Device device = test::device_named(test::shipped_devices(), "tx2-gpu");
  device.kernel.measured = {{1000, 1e-5, 1e-4}, {4000, 4e-5, 4e-4}, {16000, 1e-4, std::nullopt}};
  const auto work_of = [](double nodes, int domain) {
    return *workload_at_resolution(1000, 1e6 / nodes, {domain, 200, 4});
  };
  EXPECT_NEAR(product_cost(device, work_of(2000, 1)).seconds, 2e-5, 1e-9);  // on the line
  EXPECT_NEAR(product_cost(device, work_of(2000, 1)).joules, 2e-4, 1e-8);
  EXPECT_NEAR(product_cost(device, work_of(32000, 1)).seconds, 2e-4, 1e-8);   // beyond: in proportion
  EXPECT_NEAR(product_cost(device, work_of(16000, 1)).joules, 2.5e-4, 1e-8);  // not metered: active power x time
  EXPECT_NEAR(product_cost(device, work_of(500, 1)).seconds, 1e-5, 1e-12);    // below: never less than the smallest
  EXPECT_GT(product_cost(device, work_of(16000, 27)).seconds, 3e-4);          // other blocks: the model
}

GridSurface surface_of(const std::function<double(double, double)>& value) {
  GridSurface surface;
  surface.grid = {{0, 1, 2, 3, 4}, {0, 2, 4, 6}};
  for (const double v : surface.grid.volumes_cm3) {
    for (const double r : surface.grid.resolutions_mm3) surface.values.push_back(value(v, r));
  }
  return surface;
}

TEST(Contour, OfAPlaneIsItsStraightLine) {
  const auto segments = contour(surface_of([](double v, double r) { return 3 * v + r; }), 7.5);
  ASSERT_FALSE(segments.empty());
  double length = 0;
  for (const ContourSegment& segment : segments) {
    for (const auto& point : {segment.from, segment.to}) EXPECT_NEAR(3 * point[0] + point[1], 7.5, 1e-12);
    length += std::hypot(segment.to[0] - segment.from[0], segment.to[1] - segment.from[1]);
  }
  // From (2.5, 0) to (0.5, 6).
  EXPECT_NEAR(length, std::hypot(2, 6), 1e-12);
  EXPECT_TRUE(contour(surface_of([](double v, double r) { return 3 * v + r; }), 100).empty());
}

TEST(Contour, SaddleIsCutInTwo) {
  GridSurface saddle;
  saddle.grid = {{0, 1}, {0, 1}};
  saddle.values = {1, 0, 0, 1};
  EXPECT_EQ(contour(saddle, 0.5).size(), 2u);
}

TEST(HotSpots, AreWhereBothNeighboursAreCooler) {
  auto surface = surface_of([](double v, double r) { return v + r; });
  EXPECT_TRUE(hot_spots(surface, 0).empty());
  surface.values[1 * 4 + 2] += 10;
  const auto spots = hot_spots(surface, 0.5);
  ASSERT_EQ(spots.size(), 1u);
  EXPECT_EQ(spots[0].volume, 1u);
  EXPECT_EQ(spots[0].resolution, 2u);
  EXPECT_NEAR(spots[0].rise, (1 + 4 + 10) - (2 + 6), 1e-12);
}

}  // namespace
}  // namespace glisson::hardware
