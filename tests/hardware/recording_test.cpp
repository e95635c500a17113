// Recordings as they lie in files: which column is what, an analyser's log, and measured ones taken apart.

#include "hardware/recording.h"

#include <gmock/gmock.h>
#include <algorithm>

#include "base/files.h"
#include "measured_recordings.h"
#include "support/data.h"

namespace glisson::hardware {
namespace {

TraceFormat guessed(const char* text) {
  const auto table = parse_csv(text);
  EXPECT_TRUE(table) << table.error().message();
  return guessed_format(*table);
}

TEST(GuessedFormat, GoesByNamesAndUnits) {
  const TraceFormat format = guessed("Rail;Power (mW);t_ms\n1;3000;0\n1;3100;10\n1;3050;20\n");
  EXPECT_EQ(format.time_column, "3");
  EXPECT_EQ(format.seconds_per_unit, 1e-3);
  EXPECT_EQ(format.channels.at(0).column, "2");
  EXPECT_EQ(format.channels.at(0).amperes_per_volt, 1e-3);
}

TEST(GuessedFormat, FindsTheProductOfVoltageAndCurrentAndTurnsItsSign) {
  const TraceFormat format = guessed("0,-2,4,-8,25\n1,-2.1,3.9,-8.19,25\n2,-1.9,3.8,-7.22,25\n");
  EXPECT_EQ(format.time_column, "1");
  EXPECT_EQ(format.channels.at(0).column, "4");
  EXPECT_LT(format.channels.at(0).amperes_per_volt, 0);
}

TEST(GuessedFormat, OneColumnIsPowerWithRowsASecondApart) {
  const TraceFormat format = guessed("230\n229\n231\n");
  EXPECT_EQ(format.time_column, "");
  EXPECT_EQ(format.channels.at(0).column, "1");
}

// Twelve readings, the fifth missing, across midnight on the last day of a month.
std::string analyser_log() {
  std::string log;
  for (int i = 0; i < 12; ++i) {
    log += i < 6 ? "Time,01-31-2022 23:59:" + std::to_string(54 + i) + ".500"
                 : "Time,02-01-2022 00:00:0" + std::to_string(i - 6) + ".500";
    log += i == 4 ? ",Watts,-2.0" : ",Watts," + std::to_string(3 + i);
    log += ",Volts,230.1,Mark,notset\n";
  }
  return log;
}

TEST(AnalyserLog, IsReadByTimeOverMidnightAndWithoutMissingReadings) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "spl.txt", analyser_log()));
  const auto table = read_recording(folder.path() / "spl.txt");
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_THAT(table->names, testing::ElementsAre("Time", "Watts", "Volts"));
  const auto trace = power_trace(*table, guessed_format(*table), folder.path() / "spl.txt");
  ASSERT_TRUE(trace) << trace.error().message();
  EXPECT_EQ(trace->dropped_rows, 1u);
  ASSERT_EQ(trace->time_s.size(), 11u);
  EXPECT_NEAR(trace->time_s.back(), 11, 1e-9);
  EXPECT_NEAR(trace->power_W.back(), 14, 1e-9);
}

TEST(AnalyserLog, WithoutTimesIsRefusedWithASentence) {
  const TemporaryFolder folder;
  for (const char* text : {"Time,now,Watts,3\n", "Time,01-31-2022 23:59:54\n", "Time,13-31-2022 23:59:54,Watts,3\n"}) {
    ASSERT_TRUE(write_text_file(folder.path() / "spl.txt", text));
    const auto table = read_recording(folder.path() / "spl.txt");
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().code, "recording-without-time");
  }
}

// What the benchmark's own marks say of the same log: the mean power between them, and the lowest tenth outside.
TEST(MeasuredRecordings, RunInAnAnalysersLogIsTheOneThatItsMarksName) {
  GLISSON_NEEDS_DATA("mlperf_edge_power");
  const auto folder = glisson::test::shared_data() / "mlperf_edge_power" / "v2.0" / "Krai" /
                      "odroid-armnn-v21.11-neon" / "resnet50" / "singlestream";
  const auto marked = test::analyser_run(folder);
  const auto table = read_recording(folder / "spl.txt");
  ASSERT_TRUE(table) << table.error().message();
  const auto trace = power_trace(*table, guessed_format(*table), folder / "spl.txt");
  ASSERT_TRUE(trace) << trace.error().message();
  const auto found = find_runs(*trace);
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_FALSE(found->runs.empty());
  const auto longest = std::max_element(found->runs.begin(), found->runs.end(),
                                        [](auto& a, auto& b) { return a.seconds() < b.seconds(); });
  EXPECT_NEAR(longest->mean_W, marked.active_W, 0.02 * marked.active_W);
  // Pauses hold other work of the board, its lowest tenth none.
  EXPECT_GE(found->idle_W, marked.idle_W);
  EXPECT_LT(found->idle_W, 1.3 * marked.idle_W);
}

TEST(MeasuredRecordings, BatteryTestersTableWithoutHeadingsIsUnderstood) {
  GLISSON_NEEDS_DATA("battery_samsung_30q");
  const auto file = glisson::test::shared_data() / "battery_samsung_30q" / "S001" / "Q30_S001_1C.csv";
  const auto table = read_recording(file);
  ASSERT_TRUE(table) << table.error().message();
  const TraceFormat format = guessed_format(*table);
  EXPECT_EQ(format.time_column, "1");
  EXPECT_EQ(format.channels.at(0).column, "4");  // SOURCE.txt: time, current, voltage, power, ...
  const auto trace = power_trace(*table, format, file);
  ASSERT_TRUE(trace) << trace.error().message();
  EXPECT_GT(mean_power_W(*trace), 9);  // 3 A at 2.5 to 4.1 V
  EXPECT_LT(mean_power_W(*trace), 12.3);
}

TEST(MeasuredRecordings, RailWithoutTimesIsReadAsRowsThatFollowEachOther) {
  GLISSON_NEEDS_DATA("jetson_tx2_rail_power");
  const auto file = glisson::test::shared_data() / "jetson_tx2_rail_power" / "1080p" / "elephant_cpu.txt";
  const auto table = read_recording(file);
  ASSERT_TRUE(table) << table.error().message();
  const auto trace = power_trace(*table, guessed_format(*table), file);
  ASSERT_TRUE(trace) << trace.error().message();
  EXPECT_EQ(trace->sample_interval_s, 1);
  EXPECT_NEAR(mean_power_W(*trace), test::mean_of_lines(file), 0.05 * test::mean_of_lines(file));
}

}  // namespace
}  // namespace glisson::hardware
