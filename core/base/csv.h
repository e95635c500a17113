#pragma once
// Tables of numbers in text: oscilloscopes, test benches, spreadsheets.

#include <cstdint>
#include <filesystem>
#include <string>
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

// Commas, semicolons or tabs, whichever the first row with numbers has; a dot in numbers; lines may end in CR LF and a
// byte-order mark may lead. The header is the last line before the first row with numbers that has as many cells.
// Rows that are shorter than the first end in NaN; longer ones are cut.
// Refused: no row of numbers, more than 256 columns, files above the limit, long tables most of whose cells are
// missing.
Result<CsvTable> read_csv(const std::filesystem::path& file, std::uint64_t limit_bytes = std::uint64_t{1} << 29);
Result<CsvTable> parse_csv(std::string_view text, const std::filesystem::path& file = {});

}  // namespace glisson
