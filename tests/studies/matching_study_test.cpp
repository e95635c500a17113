// The study of chapter 3: that it counts as the dissertation counts, goes on where it was stopped, and says how near
// sixteen bits are to double precision.

#include "studies/dissertation/matching_study.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "studies/dissertation/internal/matching_problems.h"
#include "support/data.h"
#include "support/opencl.h"

namespace glisson::studies {
namespace {

using registration::WordWidth;

MatchingOptions small_study() {
  MatchingOptions options;
  options.points = {24, 40};
  options.livers = 2;
  options.starts = {0};
  options.seconds_a_timing = 0;
  return options;
}

// Sections 3.2, 3.2.1 and 3.4.4: 66 MB at 64 points; 464 and 0.08 GB/s at 110; arithmetic short by a factor of 17 at
// 256 points, where the messages need what the platform has.
TEST(MatchingDemand, IsWhatTheDissertationStates) {
  EXPECT_NEAR(matching_demand(64, 20, 20).field_MB, 66, 0.5);
  EXPECT_NEAR(matching_demand(110, 20, 20).field_GB_per_s, 464, 0.5);
  EXPECT_NEAR(matching_demand(110, 20, 20).distances_GB_per_s, 0.08, 0.005);
  EXPECT_NEAR(matching_demand(256, 20, 20).costs_G_per_s / 102.4, 17, 0.5);
  EXPECT_NEAR(matching_demand(256, 20, 20).messages_GB_per_s, 12, 1.5);
  EXPECT_GT(matching_demand(60, 20, 20).field_GB_per_s, 12);  // "not possible for n >= 60"
}

TEST(MatchingStudy, JudgesBitsAndGoesOnWhereItWasStopped) {
  const TemporaryFolder out;
  const auto study = run_matching(out.path(), small_study());
  ASSERT_TRUE(study) << study.error().message();
  ASSERT_EQ(study->rows.size(), 4u);  // two livers, there and back
  EXPECT_TRUE(study->simulated);
  for (const BatchRow& row : study->rows) EXPECT_TRUE(row.error.empty()) << row.error;
  ASSERT_EQ(study->quality.size(), 6u);
  for (const MatchingQuality& of : study->quality) {
    EXPECT_EQ(of.problems, 4u);
    EXPECT_GE(of.worst_delta, of.mean_delta);
    EXPECT_GE(of.mean_delta, std::abs(of.mean_signed));
    if (of.width == WordWidth::bits_32) {
      EXPECT_LT(of.mean_delta, 0.001);
    }
  }
  // Figure 3.8, of all widths.
  ASSERT_EQ(study->energy_by_pass.size(), 4u);
  for (const auto& energies : study->energy_by_pass) EXPECT_EQ(energies.size(), 20u);
  const auto minimum = [](const std::vector<double>& energies) {
    return *std::min_element(energies.begin(), energies.end());
  };
  EXPECT_LT(minimum(study->energy_by_pass[2]), 1.1 * minimum(study->energy_by_pass[0]));

  ASSERT_TRUE(write_matching(out.path(), *study));
  for (const char* file : {"problems.csv", "quality.csv", "timing.csv", "demand.csv", "summary.json", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out.path() / file)) << file;
  }
  std::filesystem::remove(out.path() / "patients" / (study->rows[1].id + ".json"));
  const auto again = run_matching(out.path(), small_study());
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_FALSE(again->rows[1].reused);
  EXPECT_TRUE(again->rows[0].reused);
  EXPECT_EQ(again->rows[1].values, study->rows[1].values);
}

TEST(MatchingStudy, TimesEveryWayAndSaysWhatThePlatformsCanDo) {
  const TemporaryFolder out;
  MatchingOptions options = small_study();
  options.points = {32};
  options.livers = 1;
  options.seconds_a_timing = 0.01;
  const auto study = run_matching(out.path(), options);
  ASSERT_TRUE(study) << study.error().message();
  ASSERT_GE(study->timings.size(), 5u);
  for (const MatchingTiming& timing : study->timings) {
    EXPECT_GT(timing.seconds, 0) << timing.name;
    EXPECT_EQ(timing.watts.has_value(), timing.joules.has_value());
  }
  ASSERT_EQ(study->platforms.size(), 2u);
  const MatchingDevice& dissertation = study->platforms[0];
  EXPECT_LT(dissertation.points_by_field, 60);
  EXPECT_NEAR(dissertation.points_by_costs, 126, 2);     // 128 points at 20 scans a second
  EXPECT_NEAR(dissertation.points_by_messages, 247, 3);  // "around n = 256"
}

TEST(MatchingStudy, TimesAnOpenClDeviceToo) {
  GLISSON_NEEDS_OPENCL();
  const TemporaryFolder out;
  MatchingOptions options = small_study();
  options.points = {24};
  options.livers = 1;
  options.seconds_a_timing = 0.01;
  options.device = "";
  const auto study = run_matching(out.path(), options);
  ASSERT_TRUE(study) << study.error().message();
  EXPECT_TRUE(std::any_of(study->timings.begin(), study->timings.end(), [](const MatchingTiming& timing) {
    return timing.name.find("OpenCL") != std::string::npos && timing.seconds > 0;
  }));
  options.device = "no such device";
  EXPECT_EQ(run_matching(out.path(), options).error().code, "opencl-no-device");
}

TEST(MatchingStudy, RefusesWhatItCannotDo) {
  const TemporaryFolder out;
  for (const auto& spoil : std::vector<std::function<void(MatchingOptions&)>>{
           [](auto& options) {
             options.points = {64, 32};
           },
           [](auto& options) { options.points = {}; }, [](auto& options) { options.starts = {-1}; },
           [](auto& options) { options.passes = 0; }, [](auto& options) { options.shapes = {{"one.ply"}}; }}) {
    MatchingOptions options = small_study();
    spoil(options);
    EXPECT_EQ(run_matching(out.path(), options).error().code, "study-options");
  }
  MatchingOptions options = small_study();
  options.shapes = {{"no-such.ply", "nor-this.ply"}};
  EXPECT_FALSE(run_matching(out.path(), options));
}

TEST(BentSurface, IsTheSameSurfaceInAnotherPose) {
  geometry::Surface flat;
  flat.points_mm = {{0, 0, 0}, {100, 0, 0}, {50, 40, 0}, {50, -40, 0}};
  flat.triangles = {{0, 1, 2}, {1, 0, 3}};
  const geometry::Surface pose = bent(flat, 0.7);
  EXPECT_EQ(pose.triangles, flat.triangles);
  EXPECT_LT((pose.points_mm[1] - pose.points_mm[0]).norm(), 99);  // a chord
  EXPECT_NEAR((pose.points_mm[2] - pose.points_mm[3]).norm(), 80, 1e-9);
}

}  // namespace
}  // namespace glisson::studies
