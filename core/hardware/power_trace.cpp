#include "hardware/power_trace.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/upper_median.h"
#include "hardware/recording.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t minimum_trace_samples = 10;
constexpr double gap_in_intervals = 5;
constexpr double shortest_in_intervals = 5;

Result<void> check(const TraceFormat& format);
std::vector<bool> clipped_samples(const std::vector<double>& values, const std::optional<double>& clips_at);

// A stretch of samples [first, last], all of one level, without a gap inside.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  bool running = false;
  bool after_gap = false;   // recording resumed here
  bool before_gap = false;  // and stopped there
};

std::vector<double> smoothed(const PowerTrace& trace, double window_s);
Result<double> separating_power_W(const std::vector<double>& power_W);
std::vector<Stretch> stretches_of(const PowerTrace& trace, const std::vector<double>& smooth_W, double threshold_W);
void absorb_short(const PowerTrace& trace, bool running, double shortest_s, std::vector<Stretch>& stretches);
double mean_power_W(const PowerTrace& trace, std::size_t first, std::size_t last);
std::optional<double> pause_power_W(const PowerTrace& trace, const Stretch& pause);
std::vector<Sentence> warnings_on(const PowerTrace& trace, const TraceRuns& runs, std::size_t gaps);

}  // namespace

Result<PowerTrace> read_power_trace(const std::filesystem::path& file, const TraceFormat& format) {
  if (const auto checked = check(format); !checked) return failure(checked.error());
  return read_recording(file).and_then([&](const CsvTable& table) { return power_trace(table, format, file); });
}

Result<PowerTrace> power_trace(const CsvTable& table, const TraceFormat& format, const std::filesystem::path& file) {
  if (const auto checked = check(format); !checked) return failure(checked.error());
  std::optional<std::size_t> time;
  if (!format.time_column.empty()) {
    const auto column = table.column(format.time_column);
    if (!column) return failure(Error(column.error()).in_file(file));
    time = *column;
  }
  std::vector<std::size_t> columns;
  std::vector<std::vector<bool>> clipped;
  for (const ClampChannel& channel : format.channels) {
    const auto column = table.column(channel.column);
    if (!column) return failure(Error(column.error()).in_file(file));
    columns.push_back(*column);
    clipped.push_back(clipped_samples(table.columns[*column], channel.clips_at));
  }

  PowerTrace trace;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time_s = (time ? table.columns[*time][row] : static_cast<double>(row)) * format.seconds_per_unit;
    double power_W = 0;
    bool at_end = false;
    bool missing = false;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = table.columns[columns[c]][row];
      missing = missing || (format.missing_marker && value == *format.missing_marker);
      power_W += value * format.channels[c].amperes_per_volt * format.channels[c].supply_voltage_V;
      at_end = at_end || clipped[c][row];
    }
    if (missing || !std::isfinite(time_s) || !std::isfinite(power_W)) {
      ++trace.dropped_rows;
      continue;
    }
    if (!trace.time_s.empty() && time_s <= trace.time_s.back()) {
      return failure(Error{"trace-time-goes-back",
                           GLISSON_TEXT("{0}: after {1} s comes {2} s."),
                           {file.string(), fmt::format("{:g}", trace.time_s.back()), fmt::format("{:g}", time_s)},
                           GLISSON_TEXT("Give the column that holds the time, or cut the file there."),
                           file});
    }
    trace.time_s.push_back(time_s);
    trace.power_W.push_back(power_W);
    trace.clipped.push_back(at_end);
  }
  if (trace.time_s.size() < minimum_trace_samples || trace.dropped_rows > table.rows() / 10) {
    return failure(Error{"trace-too-poor",
                         GLISSON_TEXT("{0}: samples {1}, rows without a reading {2}."),
                         {file.string(), std::to_string(trace.time_s.size()), std::to_string(trace.dropped_rows)},
                         GLISSON_TEXT("Check the columns; at most every tenth row may be empty."),
                         file});
  }
  std::vector<double> steps(trace.time_s.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = trace.time_s[i + 1] - trace.time_s[i];
  trace.sample_interval_s = upper_median(std::move(steps));
  return trace;
}

double TraceRuns::above_idle_W() const {
  std::vector<double> above_W;
  for (const TraceRun& run : runs) above_W.push_back(run.mean_W - run.idle_W);
  return upper_median(std::move(above_W));
}

double mean_power_W(const PowerTrace& trace) {
  return trace.power_W.empty() ? 0 : mean_power_W(trace, 0, trace.power_W.size() - 1);
}

Result<TraceRuns> find_runs(const PowerTrace& trace, const RunOptions& options) {
  const double shortest_s = shortest_in_intervals * trace.sample_interval_s;
  const double shortest_run_s = std::max(options.shortest_run_s, shortest_s);
  const std::vector<double> smooth_W = smoothed(trace, shortest_run_s / 2);
  const auto threshold_W = separating_power_W(smooth_W);
  if (!threshold_W) return failure(threshold_W.error());
  std::vector<Stretch> stretches = stretches_of(trace, smooth_W, *threshold_W);
  absorb_short(trace, false, std::max(options.shortest_pause_s, shortest_s), stretches);
  absorb_short(trace, true, shortest_run_s, stretches);

  TraceRuns found;
  std::vector<double> idle_W;
  for (const Stretch& stretch : stretches) {
    if (stretch.running) continue;
    for (std::size_t i = stretch.first; i <= stretch.last; ++i) idle_W.push_back(trace.power_W[i]);
  }
  found.idle_W = idle_W.empty() ? 0 : upper_median(idle_W);

  std::size_t gaps = 0;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const Stretch& stretch = stretches[s];
    gaps += stretch.after_gap ? 1 : 0;
    if (!stretch.running) continue;
    std::vector<double> beside_W;
    if (s > 0 && !stretches[s - 1].running) {
      if (const auto power_W = pause_power_W(trace, stretches[s - 1])) beside_W.push_back(*power_W);
    }
    if (s + 1 < stretches.size() && !stretches[s + 1].running) {
      if (const auto power_W = pause_power_W(trace, stretches[s + 1])) beside_W.push_back(*power_W);
    }
    TraceRun run;
    run.begin_s = trace.time_s[stretch.first];
    run.end_s = trace.time_s[stretch.last];
    run.mean_W = mean_power_W(trace, stretch.first, stretch.last);
    run.idle_W = beside_W.empty()
                     ? found.idle_W
                     : std::accumulate(beside_W.begin(), beside_W.end(), 0.0) / static_cast<double>(beside_W.size());
    run.joules_above_idle = (run.mean_W - run.idle_W) * run.seconds();
    const auto clipped = std::count(trace.clipped.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                                    trace.clipped.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1, true);
    run.clipped_fraction = static_cast<double>(clipped) / static_cast<double>(stretch.last - stretch.first + 1);
    run.cut_by_gap = stretch.after_gap || stretch.before_gap;
    found.runs.push_back(run);
  }
  found.warnings = warnings_on(trace, found, gaps);
  return found;
}

Result<std::vector<MeasuredProduct>> products_from_runs(const TraceRuns& runs, const std::vector<RunLog>& log) {
  if (runs.runs.size() != log.size()) {
    return failure(Error{"runs-do-not-match",
                         GLISSON_TEXT("Runs in the trace: {0}, in the log: {1}."),
                         {std::to_string(runs.runs.size()), std::to_string(log.size())},
                         GLISSON_TEXT("Change the shortest run and pause, or cut the trace to the logged runs."),
                         {}});
  }
  std::vector<MeasuredProduct> products;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const TraceRun& run = runs.runs[i];
    if (!(log[i].nodes >= 1 && log[i].products >= 1 && run.joules_above_idle > 0)) {
      return failure("run-without-work", GLISSON_TEXT("Run {0} drew nothing above idle, or nothing was run in it."),
                     {std::to_string(i + 1)});
    }
    products.push_back({log[i].nodes, run.seconds() / log[i].products, run.joules_above_idle / log[i].products});
  }
  std::sort(products.begin(), products.end(), [](auto& a, auto& b) { return a.nodes < b.nodes; });
  return products;
}

namespace {

Result<void> check(const TraceFormat& format) {
  bool sound = !format.channels.empty() && format.seconds_per_unit > 0 && std::isfinite(format.seconds_per_unit);
  for (const ClampChannel& channel : format.channels) {
    sound = sound && channel.amperes_per_volt != 0 && channel.supply_voltage_V > 0 &&
            std::isfinite(channel.amperes_per_volt * channel.supply_voltage_V) &&
            (!channel.clips_at || *channel.clips_at > 0);
  }
  if (sound) return {};
  return failure("trace-format-invalid",
                 GLISSON_TEXT("A trace needs a channel, factors other than 0, and a range that is positive."));
}

// At or within a thousandth of the stated end of the range; or, where none is stated, on a pile at the extreme: at
// least three equal samples in a row at the largest value, which occurs three times as often as the next one. Noise
// thins out towards its extreme; a clipped channel piles up there.
std::vector<bool> clipped_samples(const std::vector<double>& values, const std::optional<double>& clips_at) {
  std::vector<bool> clipped(values.size(), false);
  double end = 0;
  if (clips_at) {
    end = *clips_at * 0.999;
  } else {
    for (const double value : values) end = std::max(end, std::abs(value));
    double next = 0;
    std::size_t at_end = 0;
    std::size_t in_a_row = 0;
    std::size_t longest_row = 0;
    for (const double value : values) {
      const bool extreme = std::abs(value) == end;
      at_end += extreme ? 1 : 0;
      in_a_row = extreme ? in_a_row + 1 : 0;
      longest_row = std::max(longest_row, in_a_row);
      if (!extreme && std::abs(value) > next) next = std::abs(value);
    }
    const auto at_next = std::count_if(values.begin(), values.end(), [next](double v) { return std::abs(v) == next; });
    if (longest_row < 3 || at_end < 3 * static_cast<std::size_t>(at_next) || at_end == values.size()) return clipped;
  }
  for (std::size_t i = 0; i < values.size(); ++i) clipped[i] = std::abs(values[i]) >= end;
  return clipped;
}

// The running mean over a window centred on each sample; sums of neighbours, so a gap does not matter here.
std::vector<double> smoothed(const PowerTrace& trace, double window_s) {
  const auto half = static_cast<std::size_t>(std::min(window_s / trace.sample_interval_s / 2, 1e6));
  const std::size_t count = trace.power_W.size();
  std::vector<double> sums(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + trace.power_W[i];
  std::vector<double> smooth_W(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t reach = std::min({half, i, count - 1 - i});
    smooth_W[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
  }
  return smooth_W;
}

// Otsu 1979: the threshold for which the variance between the two classes is largest.
Result<double> separating_power_W(const std::vector<double>& power_W) {
  std::vector<double> sorted = power_W;
  std::sort(sorted.begin(), sorted.end());
  const double count = static_cast<double>(sorted.size());
  const double total = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  double below = 0;
  double best = -1;
  std::size_t split = 0;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    below += sorted[i];
    const double n = static_cast<double>(i + 1);
    const double difference = below / n - (total - below) / (count - n);
    const double between = n * (count - n) * difference * difference;
    if (between > best) {
      best = between;
      split = i + 1;
    }
  }
  const auto mean_and_variance = [&](std::size_t first, std::size_t last) {
    const double n = static_cast<double>(last - first);
    double mean = 0;
    for (std::size_t i = first; i < last; ++i) mean += sorted[i] / n;
    double variance = 0;
    for (std::size_t i = first; i < last; ++i) variance += (sorted[i] - mean) * (sorted[i] - mean) / n;
    return std::pair(mean, variance);
  };
  const auto [low, low_variance] = mean_and_variance(0, split);
  const auto [high, high_variance] = mean_and_variance(split, sorted.size());
  // Runs may differ much from one another, so the scatter is that of the quieter level.
  if (split == 0 || high - low <= 3 * std::sqrt(std::min(low_variance, high_variance))) {
    return failure(
        Error{"trace-without-runs",
              GLISSON_TEXT("The power does not move between two levels, so no runs can be told from pauses."),
              {},
              GLISSON_TEXT("Record pauses between the runs; check that the right column was read."),
              {}});
  }
  return (low + high) / 2;
}

std::vector<Stretch> stretches_of(const PowerTrace& trace, const std::vector<double>& smooth_W, double threshold_W) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < smooth_W.size(); ++i) {
    const bool running = smooth_W[i] > threshold_W;
    const bool gap = i > 0 && trace.time_s[i] - trace.time_s[i - 1] > gap_in_intervals * trace.sample_interval_s;
    if (gap) stretches.back().before_gap = true;
    if (i == 0 || gap || running != stretches.back().running) stretches.push_back({i, i, running, gap, false});
    stretches.back().last = i;
  }
  return stretches;
}

// Short stretches of one level become part of what is around them, where no gap stands between.
void absorb_short(const PowerTrace& trace, bool running, double shortest_s, std::vector<Stretch>& stretches) {
  std::vector<Stretch> kept;
  for (Stretch stretch : stretches) {
    const double seconds = trace.time_s[stretch.last] - trace.time_s[stretch.first];
    const bool alone = stretch.after_gap && stretch.before_gap;
    if (stretch.running == running && seconds < shortest_s && !alone) stretch.running = !running;
    if (!kept.empty() && kept.back().running == stretch.running && !stretch.after_gap) {
      kept.back().last = stretch.last;
      kept.back().before_gap = stretch.before_gap;
    } else {
      kept.push_back(stretch);
    }
  }
  stretches = std::move(kept);
}

double mean_power_W(const PowerTrace& trace, std::size_t first, std::size_t last) {
  if (first == last) return trace.power_W[first];
  double joules = 0;
  for (std::size_t i = first; i < last; ++i) {
    joules += (trace.time_s[i + 1] - trace.time_s[i]) * (trace.power_W[i] + trace.power_W[i + 1]) / 2;
  }
  return joules / (trace.time_s[last] - trace.time_s[first]);
}

// Without the tenth at each end, where the neighbouring runs rise and fall; nothing from a pause of a few samples.
std::optional<double> pause_power_W(const PowerTrace& trace, const Stretch& pause) {
  const std::size_t count = pause.last - pause.first + 1;
  if (count < minimum_trace_samples) return {};
  const std::size_t trim = count / 10;
  return mean_power_W(trace, pause.first + trim, pause.last - trim);
}

std::vector<Sentence> warnings_on(const PowerTrace& trace, const TraceRuns& runs, std::size_t gaps) {
  std::vector<Sentence> warnings;
  if (gaps > 0) {
    warnings.push_back({GLISSON_TEXT("Gaps in the recording: {0}; runs end there and nothing is made up for them."),
                        {std::to_string(gaps)}});
  }
  if (trace.dropped_rows > 0)
    warnings.push_back({GLISSON_TEXT("Rows without a reading: {0}."), {std::to_string(trace.dropped_rows)}});
  const auto clipped =
      std::count_if(runs.runs.begin(), runs.runs.end(), [](auto& run) { return run.clipped_fraction > 0; });
  if (clipped > 0) {
    warnings.push_back(
        {GLISSON_TEXT("Runs that reach the end of a channel's range, so that their power is a lower bound: {0}. "
                      "Record again with a larger range."),
         {std::to_string(clipped)}});
  }
  if (runs.runs.size() >= 2 && runs.idle_W > 0) {
    const double drift_W = runs.runs.back().idle_W - runs.runs.front().idle_W;
    if (std::abs(drift_W) > 0.1 * runs.idle_W) {
      warnings.push_back({GLISSON_TEXT("Idle power moves by {0} W over the recording; each run is compared with the "
                                       "pauses beside it."),
                          {fmt::format("{:.3g}", drift_W)}});
    }
  }
  return warnings;
}

}  // namespace
}  // namespace glisson::hardware
