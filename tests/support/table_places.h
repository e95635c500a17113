#pragma once
// Places in a table of a sequence (hidden.csv, hidden-truth.csv).

#include <Eigen/Core>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"

namespace glisson::test {

// The last three columns of the rows that begin so, the table's head left out.
inline std::vector<Eigen::Vector3d> places_in(const std::filesystem::path& table, const std::string& beginning = {}) {
  std::stringstream text(read_text_file(table).value());
  std::string line;
  std::getline(text, line);
  std::vector<Eigen::Vector3d> places;
  while (std::getline(text, line)) {
    if (!line.starts_with(beginning)) continue;
    std::vector<double> numbers;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) numbers.push_back(std::strtod(cell.c_str(), nullptr));
    const std::size_t n = numbers.size();
    places.emplace_back(numbers.at(n - 3), numbers.at(n - 2), numbers.at(n - 1));
  }
  return places;
}

}  // namespace glisson::test
