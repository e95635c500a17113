// Recordings of power: what is found in a clean one, a noisy one, and those with gaps and clipped channels.

#include "hardware/power_trace.h"

#include <gmock/gmock.h>
#include <cmath>
#include <fstream>
#include <random>

#include "base/files.h"

namespace glisson::hardware {
namespace {

// Two clamps of 10 A/V on 12 V and 5 V: a device that idles at 30 W and runs three times, at 50, 70 and 60 W.
struct Recording {
  double interval_s = 0.01;
  double noise_V = 0;
  double clips_at_V = 1e9;
  double lost_from_s = 1e9;
  double lost_to_s = 1e9;

  [[nodiscard]] static double power_W(double t) {
    if (t >= 2 && t < 4) return 50;
    if (t >= 6 && t < 7) return 70;
    if (t >= 9 && t < 12) return 60;
    return 30;
  }

  void write(const std::filesystem::path& file) const {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 1);
    std::ofstream stream(file);
    stream << "Hantek6074BE\nt_ms;CH1;CH2\n";
    for (int i = 0; i * interval_s < 14; ++i) {
      const double t = i * interval_s;
      if (t >= lost_from_s && t < lost_to_s) continue;
      const double on_12_V = power_W(t) * 0.75 / 12 / 10 + noise_V * noise(random);
      const double on_5_V = power_W(t) * 0.25 / 5 / 10 + noise_V * noise(random);
      stream << t * 1e3 << ';' << std::min(on_12_V, clips_at_V) << ';' << on_5_V << '\n';
    }
  }

  [[nodiscard]] Result<PowerTrace> read() const {
    const TemporaryFolder folder;
    write(folder.path() / "scope.csv");
    TraceFormat format;
    format.time_column = "t_ms";
    format.seconds_per_unit = 1e-3;
    format.channels = {{"CH1", 10, 12, {}}, {"CH2", 10, 5, {}}};
    return read_power_trace(folder.path() / "scope.csv", format);
  }
};

void expect_three_runs(const TraceRuns& found, double tolerance_W) {
  ASSERT_EQ(found.runs.size(), 3u);
  const double begins_s[] = {2, 6, 9};
  const double ends_s[] = {4, 7, 12};
  const double means_W[] = {50, 70, 60};
  EXPECT_NEAR(found.idle_W, 30, tolerance_W);
  for (std::size_t i = 0; i < 3; ++i) {
    // The smoothing window is a quarter of a second, so that an edge is found within half of that.
    EXPECT_NEAR(found.runs[i].begin_s, begins_s[i], 0.13);
    EXPECT_NEAR(found.runs[i].end_s, ends_s[i], 0.13);
    EXPECT_NEAR(found.runs[i].mean_W, means_W[i], tolerance_W);
    EXPECT_NEAR(found.runs[i].joules_above_idle, (means_W[i] - 30) * (ends_s[i] - begins_s[i]), 4 * tolerance_W);
    EXPECT_EQ(found.runs[i].clipped_fraction, 0);
  }
}

TEST(PowerTraceRuns, CleanRecordingIsTakenApart) {
  const auto trace = Recording{}.read();
  ASSERT_TRUE(trace) << trace.error().message();
  EXPECT_NEAR(trace->sample_interval_s, 0.01, 1e-9);
  const auto found = find_runs(*trace);
  ASSERT_TRUE(found);
  // An edge may be off by 7 samples of a run of 100: 40 W x 0.07 = 2.8 W for the shortest run at worst.
  expect_three_runs(*found, 2.8);
  EXPECT_TRUE(found->warnings.empty());
}

TEST(PowerTraceRuns, NoisyRecordingTheSame) {
  // 0.05 V on 12 V x 10 A/V is 6 W a sample, a third of the smallest step; the mean of 100 samples scatters by 0.6 W.
  Recording noisy;
  noisy.noise_V = 0.05;
  const auto found = find_runs(*noisy.read());
  ASSERT_TRUE(found) << found.error().message();
  expect_three_runs(*found, 4);
}

TEST(PowerTraceRuns, GapEndsARunAndIsSaid) {
  Recording gap;
  gap.lost_from_s = 10;
  gap.lost_to_s = 11;
  const auto found = find_runs(*gap.read());
  ASSERT_TRUE(found);
  ASSERT_EQ(found->runs.size(), 4u);
  EXPECT_FALSE(found->runs[0].cut_by_gap);
  for (const std::size_t half : {2u, 3u}) {
    EXPECT_TRUE(found->runs[half].cut_by_gap);
    EXPECT_NEAR(found->runs[half].seconds(), 1, 0.13);
    EXPECT_NEAR(found->runs[half].mean_W, 60, 2.8);  // nothing of the lost second is made up
  }
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_THAT(found->warnings[0].message(), testing::HasSubstr("Gaps in the recording: 1;"));
}

TEST(PowerTraceRuns, ClippedChannelIsRecognisedAndMakesALowerBound) {
  Recording clipped;
  clipped.noise_V = 0.01;
  clipped.clips_at_V = 0.40;  // 70 W would be 0.4375 V, 60 W 0.375 V
  const auto found = find_runs(*clipped.read());
  ASSERT_TRUE(found);
  ASSERT_EQ(found->runs.size(), 3u);
  EXPECT_EQ(found->runs[0].clipped_fraction, 0);
  EXPECT_GT(found->runs[1].clipped_fraction, 0.9);
  EXPECT_LT(found->runs[1].mean_W, 70);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_THAT(found->warnings[0].message(), testing::HasSubstr("lower bound"));
}

TEST(PowerTraceRuns, StatedRangeMarksClippingWithoutGuessing) {
  const TemporaryFolder folder;
  Recording{}.write(folder.path() / "scope.csv");
  TraceFormat format{"t_ms", 1e-3, {{"CH1", 10, 12, 0.4375}}, {}};  // the 70 W level exactly
  const auto trace = read_power_trace(folder.path() / "scope.csv", format);
  ASSERT_TRUE(trace);
  EXPECT_NEAR(static_cast<double>(std::count(trace->clipped.begin(), trace->clipped.end(), true)), 100, 1);
}

TEST(PowerTraceRuns, RunsAndTheirLogMakeAKernel) {
  const auto found = find_runs(*Recording{}.read());
  const auto products = products_from_runs(*found, {{5000, 1000}, {80000, 50}, {20000, 600}});
  ASSERT_TRUE(products);
  ASSERT_EQ(products->size(), 3u);
  EXPECT_EQ((*products)[1].nodes, 20000);  // by increasing nodes
  EXPECT_NEAR((*products)[1].seconds, 3.0 / 600, 3e-4);
  EXPECT_NEAR(*(*products)[1].joules, 30 * 3.0 / 600, 0.02);
  EXPECT_EQ(products_from_runs(*found, {{5000, 1000}}).error().code, "runs-do-not-match");
}

TEST(PowerTraceRuns, FlatTraceHasNoRuns) {
  PowerTrace flat;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(10, 0.5);
  for (int i = 0; i < 2000; ++i) {
    flat.time_s.push_back(i * 0.01);
    flat.power_W.push_back(noise(random));
    flat.clipped.push_back(false);
  }
  flat.sample_interval_s = 0.01;
  EXPECT_EQ(find_runs(flat).error().code, "trace-without-runs");
}

TEST(PowerTraceFile, BadOnesAreRefused) {
  const TemporaryFolder folder;
  const auto code = [&](const std::string& text, TraceFormat format) {
    EXPECT_TRUE(write_text_file(folder.path() / "t.csv", text));
    const auto trace = read_power_trace(folder.path() / "t.csv", format);
    return trace ? std::string("read") : trace.error().code;
  };
  std::string rising = "t,w\n";
  for (int i = 0; i < 20; ++i) rising += std::to_string(i) + ",5\n";
  const TraceFormat plain{"t", 1, {{"w", 1, 1, {}}}, {}};
  EXPECT_EQ(code(rising, plain), "read");
  EXPECT_EQ(code(rising + "3,5\n", plain), "trace-time-goes-back");
  EXPECT_EQ(code("t,w\n1,5\n2,5\n", plain), "trace-too-poor");
  EXPECT_EQ(code(rising + "20,\n21,\n22,\n", plain), "trace-too-poor");
  EXPECT_EQ(code(rising, {"t", 1, {{"volts", 1, 1, {}}}, {}}), "csv-no-such-column");
  EXPECT_EQ(code(rising, {"t", 1, {{"w", 0, 1, {}}}, {}}), "trace-format-invalid");
  EXPECT_EQ(code(rising, {"t", 1, {}, {}}), "trace-format-invalid");
  EXPECT_EQ(code("", plain), "csv-without-numbers");
}

TEST(PowerTraceFile, MissingReadingsAreDroppedAndCounted) {
  const TemporaryFolder folder;
  std::string text = "t,w\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + (i % 20 == 7 ? ",-2\n" : ",5\n");
  ASSERT_TRUE(write_text_file(folder.path() / "t.csv", text));
  const auto trace = read_power_trace(folder.path() / "t.csv", {"t", 1, {{"w", 1, 1, {}}}, -2.0});
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->dropped_rows, 2u);
  EXPECT_EQ(trace->power_W, std::vector<double>(38, 5.0));
}

}  // namespace
}  // namespace glisson::hardware
