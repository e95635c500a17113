#pragma once
// Readers for the measured data's own formats, and the way errors are reported.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <string>
#include <vector>

namespace glisson::hardware::test {

// One MLPerf power run: the analyser's log, the window in which the benchmark ran, and its throughput.
struct AnalyserRun {
  double idle_W = 0;    // the lowest tenth of the readings before and after
  double active_W = 0;  // mean within the window
  double queries_per_s = 0;
  std::vector<double> window_W;
};

inline double seconds_of_day(const std::string& stamp) {  // "08-07-2021 11:58:33.523"
  return std::stod(stamp.substr(11, 2)) * 3600 + std::stod(stamp.substr(14, 2)) * 60 + std::stod(stamp.substr(17));
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string first_match(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

inline AnalyserRun analyser_run(const std::filesystem::path& folder) {
  const std::string detail = content_of(folder / "mlperf_log_detail.txt");
  const double begin_s = seconds_of_day(first_match(detail, R"(power_begin", "value": "([^"]+))"));
  const double end_s = seconds_of_day(first_match(detail, R"(power_end", "value": "([^"]+))"));
  AnalyserRun run;
  run.queries_per_s =
      std::stod(first_match(content_of(folder / "mlperf_log_summary.txt"), R"(QPS w/o loadgen overhead\s*: (\S+))"));
  std::vector<double> outside_W;
  std::ifstream stream(folder / "spl.txt");
  for (std::string line; std::getline(stream, line);) {
    const std::string stamp = first_match(line, "^Time,([^,]+)");
    const double power_W = std::stod(first_match(line, "Watts,([^,]+)"));
    if (power_W < 0) continue;  // the analyser's mark for no reading
    const double time_s = seconds_of_day(stamp);
    (time_s >= begin_s && time_s <= end_s ? run.window_W : outside_W).push_back(power_W);
  }
  for (const double power_W : run.window_W) run.active_W += power_W / static_cast<double>(run.window_W.size());
  std::sort(outside_W.begin(), outside_W.end());
  const std::size_t tenth = std::max<std::size_t>(1, outside_W.size() / 10);
  for (std::size_t i = 0; i < tenth; ++i) run.idle_W += outside_W[i] / static_cast<double>(tenth);
  return run;
}

// The mean of a file with one number a line.
inline double mean_of_lines(const std::filesystem::path& file) {
  std::ifstream stream(file);
  double sum = 0;
  int count = 0;
  for (double value = 0; stream >> value; ++count) sum += value;
  return sum / count;
}

// "held out: 3C time, before +3.0 %, after +0.2 %", on the terminal for docs/hardware-plan.md.
inline void report(const std::string& what, double measured, double before, double after, const char* unit) {
  std::cout << fmt::format("held out: {:44} measured {:8.3f} {:4} before {:+7.1f} %  after {:+6.1f} %\n", what,
                           measured, unit, 100 * (before / measured - 1), 100 * (after / measured - 1));
}

}  // namespace glisson::hardware::test
