// What glisson-cli platform reads of a recording: the options, and the runs in it.

#include "base/text.h"
#include "hardware/recording.h"
#include "platform_commands.h"

namespace glisson::cli {

using namespace hardware;

namespace {

// "CH1:10:12:0.4": column, amperes a volt, supply voltage and, where known, the end of the channel's range.
Result<ClampChannel> parse_channel(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  std::vector<double> numbers;
  bool sound = parts.size() <= 4 && !parts.front().empty();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto number = read_number(parts[i]);
    sound = sound && number.has_value();
    numbers.push_back(number.value_or(0));
  }
  if (!sound) {
    return failure(
        Error{"channel-invalid",
              GLISSON_TEXT("--channel wants COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], not \"{0}\"."),
              {text},
              GLISSON_TEXT("A column that holds watts is just COLUMN."),
              {}});
  }
  ClampChannel channel{parts.front(), 1, 1, {}};
  if (!numbers.empty()) channel.amperes_per_volt = numbers[0];
  if (numbers.size() > 1) channel.supply_voltage_V = numbers[1];
  if (numbers.size() > 2) channel.clips_at = numbers[2];
  return channel;
}

// Which columns: as the person says, else as names, units and numbers tell.
Result<TraceFormat> format_of(const TraceChoice& choice, const CsvTable& table) {
  TraceFormat format = choice.format;
  const TraceFormat guessed = guessed_format(table);
  if (choice.channels.empty()) {
    format.channels = guessed.channels;
    format.time_column = guessed.time_column;
    if (format.seconds_per_unit == 1) format.seconds_per_unit = guessed.seconds_per_unit;
    if (!format.missing_marker) format.missing_marker = guessed.missing_marker;
  }
  if (!choice.time_column.empty()) format.time_column = choice.time_column;
  for (const std::string& text : choice.channels) {
    auto channel = parse_channel(text);
    if (!channel) return failure(channel.error());
    format.channels.push_back(std::move(*channel));
  }
  return format;
}

}  // namespace

CLI::Option* TraceChoice::add_options(CLI::App& command) {
  CLI::Option* trace = command.add_option("--trace", file, "Recording of its power (CSV, or a power analyser's log)");
  command
      .add_option("--channel", channels,
                  "COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], once a clamp; where left out, the power is found "
                  "by name, unit or as a product of two others")
      ->needs(trace);
  command.add_option("--time-column", time_column, "Name or number")->needs(trace);
  command.add_option("--time-unit-s", format.seconds_per_unit, "0.001 where the recording counts ms")
      ->needs(trace)
      ->capture_default_str();
  command.add_option("--missing", format.missing_marker, "A value that means no reading")->needs(trace);
  command.add_option("--shortest-run-s", runs_options.shortest_run_s, "Shorter is a disturbance")
      ->needs(trace)
      ->capture_default_str();
  command.add_option("--shortest-pause-s", runs_options.shortest_pause_s, "Shorter belongs to the run")
      ->needs(trace)
      ->capture_default_str();
  return trace;
}

Result<TraceRuns> TraceChoice::runs() const {
  const auto table = read_recording(file);
  if (!table) return failure(table.error());
  const auto chosen = format_of(*this, *table);
  if (!chosen) return failure(chosen.error());
  return power_trace(*table, *chosen, file).and_then([this](const PowerTrace& trace) {
    return find_runs(trace, runs_options);
  });
}

Json runs_json(const TraceRuns& runs) {
  Json list = Json::array();
  for (const TraceRun& run : runs.runs) {
    list.push_back({{"begin_s", run.begin_s},
                    {"end_s", run.end_s},
                    {"mean_W", run.mean_W},
                    {"idle_W", run.idle_W},
                    {"joules_above_idle", run.joules_above_idle},
                    {"clipped_fraction", run.clipped_fraction},
                    {"cut_by_gap", run.cut_by_gap}});
  }
  return {{"idle_W", runs.idle_W}, {"runs", list}, {"warnings", messages(runs.warnings)}};
}

}  // namespace glisson::cli
