#pragma once
// Power as an oscilloscope or a power analyser recorded it: reading the file, finding the runs in it, and what each run
// drew above idle.
//
// The dissertation's set-up (section 6.4, figure 6.4): contact-free current clamps on each supply of the device, and an
// oscilloscope's log. The mean static power is subtracted. There are 100 traces a device, one for each problem.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/result.h"
#include "hardware/device.h"
#include "hardware/sentence.h"

namespace glisson::hardware {

// Samples by time, and where they cannot be trusted.
struct PowerTrace {
  std::vector<double> time_s;    // strictly increasing
  std::vector<double> power_W;   // as many
  std::vector<bool> clipped;     // as many: a channel was at the end of its range, so the power was at least this
  double sample_interval_s = 0;  // the median
  std::size_t dropped_rows = 0;  // without a number, or marked as missing
};

// One clamp on one supply.
struct ClampChannel {
  std::string column;              // name in the header, or number from "1"
  double amperes_per_volt = 1;     // 1 where the file holds amperes; negative for a clamp put on the other way round
  double supply_voltage_V = 1;     // 1 where the file holds watts
  std::optional<double> clips_at;  // the end of the channel's range, in the column's unit; otherwise recognised by a
                                   // pile of equal samples at the extreme
};

struct TraceFormat {
  std::string time_column = "1";  // empty: rows follow each other every seconds_per_unit
  double seconds_per_unit = 1;
  std::vector<ClampChannel> channels;    // their powers add up; at least one
  std::optional<double> missing_marker;  // a value that means "no reading", such as an analyser's -2
};

// Fails with "csv-no-such-column", or "trace-time-goes-back". Fails with "trace-too-poor" below ten samples, or where
// every tenth row lacks numbers. Fails with "trace-format-invalid" for factors of 0 or that are not finite.
Result<PowerTrace> read_power_trace(const std::filesystem::path& file, const TraceFormat& format);
// The same of a table that was read from there (recording.h).
Result<PowerTrace> power_trace(const CsvTable& table, const TraceFormat& format, const std::filesystem::path& file);

// Over the whole trace, by time.
[[nodiscard]] double mean_power_W(const PowerTrace& trace);

struct RunOptions {
  double shortest_run_s = 0.5;    // what is shorter is a disturbance
  double shortest_pause_s = 0.5;  // what is shorter belongs to the run around it
};

struct TraceRun {
  double begin_s = 0;
  double end_s = 0;
  double mean_W = 0;
  double idle_W = 0;             // of the pauses beside it
  double joules_above_idle = 0;  // over the whole run
  double clipped_fraction = 0;   // where not zero, mean_W is a lower bound
  bool cut_by_gap = false;       // recording stopped at its beginning or its end: nothing is invented for the gap
  [[nodiscard]] double seconds() const { return end_s - begin_s; }
};

struct TraceRuns {
  double idle_W = 0;  // the median of all pauses
  std::vector<TraceRun> runs;
  std::vector<Sentence> warnings;             // gaps, clipping, drift of idle power; a person should read them
  [[nodiscard]] double above_idle_W() const;  // the median of the runs; 0 without any
};

// Splits at the power that separates two levels best (Otsu's threshold on the trace smoothed over half of
// shortest_run_s). A step in time of more than five sample intervals is a gap; a run ends there. What is shorter than
// five intervals is neither a run nor a pause, whatever the options say.
// Refused: a trace whose two levels differ by less than three times their scatter ("trace-without-runs").
Result<TraceRuns> find_runs(const PowerTrace& trace, const RunOptions& options = {});

// What was run, in order: so many products at so many nodes.
struct RunLog {
  double nodes = 0;
  double products = 0;
};

// The runs as points of a kernel, by increasing nodes. Refused: not as many runs as the log has ("runs-do-not-match"),
// runs with nothing above idle.
Result<std::vector<MeasuredProduct>> products_from_runs(const TraceRuns& runs, const std::vector<RunLog>& log);

}  // namespace glisson::hardware
