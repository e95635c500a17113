#include "base/csv.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/files.h"
#include "base/text.h"

namespace glisson {
namespace {

constexpr std::size_t maximum_columns = 256;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string_view trimmed(std::string_view cell) {
  constexpr std::string_view around = " \"\t\r";
  cell.remove_prefix(std::min(cell.find_first_not_of(around), cell.size()));
  return cell.substr(0, cell.find_last_not_of(around) + 1);
}

double number_in(std::string_view cell) {
  cell = trimmed(cell);
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  return read_number(cell).value_or(no_number);
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (cells.size() <= maximum_columns) {
    const std::size_t end = line.find(separator);
    cells.push_back(line.substr(0, end));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  return cells;
}

char separator_of(std::string_view line) {
  const auto count = [line](char c) { return std::count(line.begin(), line.end(), c); };
  char best = ',';
  for (const char candidate : {';', '\t'}) {
    if (count(candidate) > count(best)) best = candidate;
  }
  return best;
}

bool begins_with_a_number(const std::vector<std::string_view>& cells) {
  const double first = number_in(cells.front());
  return first == first;
}

// The first row of numbers begins with one, and at least half of its cells are.
bool begins_the_table(const std::vector<std::string_view>& cells) {
  const auto numbers = std::count_if(cells.begin(), cells.end(), [](auto cell) {
    const double number = number_in(cell);
    return number == number;
  });
  return begins_with_a_number(cells) && 2 * static_cast<std::size_t>(numbers) >= cells.size();
}

std::vector<std::string> names_from(std::string_view header, char separator, std::size_t count) {
  std::vector<std::string> names;
  const auto cells = cells_of(header, separator);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view name = cells.size() == count ? trimmed(cells[i]) : std::string_view();
    names.push_back(name.empty() ? std::to_string(i + 1) : std::string(name));
  }
  return names;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

// The first line of the text, which then begins after it.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

Failure refuse(const std::filesystem::path& file, std::string code, std::string text, std::string argument = {}) {
  return failure(Error{std::move(code), std::move(text), {file.string(), std::move(argument)}, {}, file});
}

}  // namespace

Result<std::size_t> CsvTable::column(const std::string& name_or_number) const {
  const auto named = std::find(names.begin(), names.end(), name_or_number);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  const auto number = read_whole_number<std::uint64_t>(name_or_number);
  if (number && *number >= 1 && *number <= columns.size()) return *number - 1;
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  return failure(Error{"csv-no-such-column",
                       GLISSON_TEXT("There is no column \"{0}\"."),
                       {name_or_number, known},
                       GLISSON_TEXT("The columns are {1}."),
                       {}});
}

Result<CsvTable> read_csv(const std::filesystem::path& file, std::uint64_t limit_bytes) {
  return read_text_file(file, limit_bytes).and_then([&](const std::string& text) { return parse_csv(text, file); });
}

Result<CsvTable> parse_csv(std::string_view text, const std::filesystem::path& file) {
  text = without_byte_order_mark(text);
  CsvTable table;
  std::string_view line_before;
  char separator = ',';
  std::size_t missing = 0;  // cells that rows shorter than the first do not have
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = next_line(text);
    if (table.columns.empty()) separator = separator_of(line);
    const auto cells = cells_of(line, separator);
    if (!(table.columns.empty() ? begins_the_table(cells) : begins_with_a_number(cells))) {
      if (!trimmed(line).empty()) {
        ++table.rows_without_numbers;
        line_before = line;
      }
      continue;
    }
    if (cells.size() > maximum_columns) return refuse(file, "csv-too-wide", GLISSON_TEXT("{0} has too many columns."));
    if (table.columns.empty()) {
      table.names = names_from(line_before, separator, cells.size());
      table.columns.resize(cells.size());
    }
    missing += table.columns.size() - std::min(table.columns.size(), cells.size());
    constexpr std::size_t maximum_missing = 1'000'000;
    if (missing > std::max(maximum_missing, table.rows() * table.columns.size() / 2)) {
      return refuse(file, "csv-ragged", GLISSON_TEXT("Most rows of {0} are far shorter than its first."));
    }
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      table.columns[c].push_back(c < cells.size() ? number_in(cells[c]) : no_number);
    table.lines.push_back(line_number);
  }
  if (table.columns.empty()) return refuse(file, "csv-without-numbers", GLISSON_TEXT("{0} holds no rows of numbers."));
  return table;
}

double CsvRow::number(std::size_t cell) const { return cell < cells.size() ? number_in(cells[cell]) : no_number; }

std::vector<CsvRow> csv_rows(std::string_view text) {
  text = without_byte_order_mark(text);
  std::vector<CsvRow> rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = next_line(text);
    if (trimmed(line).empty()) continue;
    CsvRow row{number, cells_of(line, ',')};
    for (std::string_view& cell : row.cells) cell = trimmed(cell);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace glisson
