#include "hardware/recording.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include "base/files.h"

namespace glisson::hardware {
namespace {

using Column = std::vector<double>;

constexpr std::string_view analysers_first_word = "Time,";
constexpr double analysers_no_reading = -2;

Result<CsvTable> read_analyser_log(std::string_view text, const std::filesystem::path& file);
std::optional<double> seconds_of(std::string_view stamp);

std::optional<std::size_t> time_in(const CsvTable& table);
std::optional<std::size_t> power_in(const CsvTable& table, std::optional<std::size_t> time);
double seconds_per_unit_of(const std::string& name);
double watts_per_unit_of(const std::string& name);

}  // namespace

Result<CsvTable> read_recording(const std::filesystem::path& file) {
  constexpr std::uint64_t limit_bytes = std::uint64_t{1} << 29;
  const auto text = read_text_file(file, limit_bytes);
  if (!text) return failure(text.error());
  return text->starts_with(analysers_first_word) ? read_analyser_log(*text, file) : parse_csv(*text, file);
}

TraceFormat guessed_format(const CsvTable& table) {
  TraceFormat format;
  const auto time = time_in(table);
  format.time_column = time ? std::to_string(*time + 1) : std::string();
  format.seconds_per_unit = time ? seconds_per_unit_of(table.names[*time]) : 1;
  const auto power = power_in(table, time);
  if (!power) return format;
  const std::string& name = table.names[*power];
  if (name == "Watts") format.missing_marker = analysers_no_reading;
  double sum = 0;
  for (const double value : table.columns[*power]) {
    if (std::isfinite(value) && value != format.missing_marker) sum += value;
  }
  format.channels = {{std::to_string(*power + 1), watts_per_unit_of(name) * (sum < 0 ? -1 : 1), 1, {}}};
  return format;
}

namespace {

Result<CsvTable> read_analyser_log(std::string_view text, const std::filesystem::path& file) {
  CsvTable table;
  std::optional<double> first_s;
  for (const CsvRow& row : csv_rows(text)) {
    const auto stamp = row.cells.size() > 1 ? seconds_of(row.cells[1]) : std::nullopt;
    if (!first_s) {
      if (!stamp) break;
      first_s = stamp;
      table.names = {"Time"};
      // Pairs of a name and a number, up to the first that holds none.
      for (std::size_t cell = 2; cell + 1 < row.cells.size() && std::isfinite(row.number(cell + 1)); cell += 2)
        table.names.emplace_back(row.cells[cell]);
      table.columns.resize(table.names.size());
    }
    if (!stamp) {
      ++table.rows_without_numbers;
      continue;
    }
    table.columns[0].push_back(*stamp - *first_s);
    for (std::size_t c = 1; c < table.names.size(); ++c) table.columns[c].push_back(row.number(2 * c + 1));
    table.lines.push_back(row.line);
  }
  if (table.columns.size() > 1) return table;
  return failure(Error{"recording-without-time",
                       GLISSON_TEXT("{0} begins as a power analyser's log, but its first line holds no time and no "
                                    "reading."),
                       {file.string()},
                       {},
                       file});
}

// "02-16-2022 08:59:37.009": month, day, year; seconds from some day on.
std::optional<double> seconds_of(std::string_view stamp) {
  constexpr std::string_view shape = "00-00-0000 00:00:00";
  if (stamp.size() < shape.size()) return {};
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool digit = stamp[i] >= '0' && stamp[i] <= '9';
    if (shape[i] == '0' ? !digit : stamp[i] != shape[i]) return {};
  }
  const auto number = [stamp](std::size_t first, std::size_t count) {
    int value = 0;
    for (std::size_t i = first; i < first + count; ++i) value = 10 * value + (stamp[i] - '0');
    return value;
  };
  double second = 0;
  const char* const last = stamp.data() + stamp.size();
  const auto [end, problem] = std::from_chars(stamp.data() + 17, last, second);
  const std::chrono::year_month_day day{std::chrono::year(number(6, 4)),
                                        std::chrono::month(static_cast<unsigned>(number(0, 2))),
                                        std::chrono::day(static_cast<unsigned>(number(3, 2)))};
  if (problem != std::errc() || end != last || !day.ok() || !std::isfinite(second)) return {};
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return 86400.0 * days + 3600 * number(11, 2) + 60 * number(14, 2) + second;
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// The words of a name, in small letters: "Power (mW)" is power, mw.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : in_small_letters(name)) {
    const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (part) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

bool has_any(const std::string& name, std::initializer_list<std::string_view> wanted) {
  const auto words = words_of(name);
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](std::string_view word) { return std::find(words.begin(), words.end(), word) != words.end(); });
}

bool only_grows(const Column& column) {
  for (std::size_t i = 1; i < column.size(); ++i) {
    if (!(column[i] > column[i - 1])) return false;
  }
  return column.size() > 1;
}

std::optional<std::size_t> time_in(const CsvTable& table) {
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (has_any(table.names[c], {"time", "t", "seconds", "elapsed", "timestamp"})) return c;
  }
  if (table.columns.size() < 2) return {};
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (only_grows(table.columns[c])) return c;
  }
  return {};
}

// Voltage times current, to a hundredth of what there is of it.
bool is_product(const Column& power, const Column& a, const Column& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    if (!std::isfinite(power[i] + a[i] * b[i])) continue;
    difference += std::abs(power[i] - a[i] * b[i]);
    size += std::abs(power[i]);
  }
  return size > 0 && difference <= 0.01 * size;
}

std::optional<std::size_t> power_in(const CsvTable& table, std::optional<std::size_t> time) {
  const std::size_t count = table.columns.size();
  for (std::size_t c = 0; c < count; ++c) {
    if (c != time && has_any(table.names[c], {"power", "watt", "watts", "w", "mw"})) return c;
  }
  constexpr std::size_t most_columns = 16;
  const std::size_t looked_at = std::min(count, most_columns);
  for (std::size_t c = 0; c < looked_at; ++c) {
    for (std::size_t a = 0; a < looked_at; ++a) {
      for (std::size_t b = a + 1; b < looked_at; ++b) {
        const bool apart = c != a && c != b && c != time && a != time && b != time;
        if (apart && is_product(table.columns[c], table.columns[a], table.columns[b])) return c;
      }
    }
  }
  for (std::size_t c = 0; c < count; ++c) {
    if (c != time) return c;
  }
  return {};
}

double seconds_per_unit_of(const std::string& name) {
  if (has_any(name, {"ms", "milliseconds"})) return 1e-3;
  if (has_any(name, {"us", "microseconds"})) return 1e-6;
  if (has_any(name, {"min", "minutes"})) return 60;
  return has_any(name, {"h", "hours"}) ? 3600 : 1;
}

double watts_per_unit_of(const std::string& name) { return has_any(name, {"mw"}) ? 1e-3 : 1; }

}  // namespace
}  // namespace glisson::hardware
