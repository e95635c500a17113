#pragma once
// Tables in text: of numbers (oscilloscopes, test benches, spreadsheets), and with names among them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace glisson {

struct CsvTable {
  std::vector<std::string> names;            // of the columns; "1", "2", ... where the file has no header
  std::vector<std::vector<double>> columns;  // NaN where a cell holds no number
  std::vector<std::size_t> lines;            // of the file, from 1, one a row
  std::size_t rows_without_numbers = 0;      // skipped: units, comments, a scope's preamble

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  // By name, or by number from "1". The error lists the names there are.
  [[nodiscard]] Result<std::size_t> column(const std::string& name_or_number) const;
};

// Cells are parted by commas, semicolons or tabs, whichever the first row with numbers has. Numbers have a dot. Lines
// may end in CR LF, and a byte-order mark may lead. The header is the last line before the first row with numbers that
// has as many cells. Rows that are shorter than the first end in NaN; longer ones are cut. Refused: no row of numbers,
// more than 256 columns, files above the limit, long tables most of whose cells are missing.
Result<CsvTable> read_csv(const std::filesystem::path& file, std::uint64_t limit_bytes = std::uint64_t{1} << 29);
Result<CsvTable> parse_csv(std::string_view text, const std::filesystem::path& file = {});

// A line of a table whose columns need not hold numbers. Cells are parts of the text, without the blanks and quotes
// around them.
struct CsvRow {
  std::size_t line = 0;  // of the text, from 1
  std::vector<std::string_view> cells;

  [[nodiscard]] double number(std::size_t cell) const;  // NaN where there is no cell, or it holds no finite number
};
// The lines that are not blank, the header among them; commas between cells. At most 257 cells of a line are read.
std::vector<CsvRow> csv_rows(std::string_view text);

}  // namespace glisson
