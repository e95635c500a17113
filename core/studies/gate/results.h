#pragma once
// The results of one version of a program over a set of cases, whoever's program it is: a folder with
//
//   metrics.csv              case,tre_mm,dice,...    a row a case, a column a metric; a cell without a number: it
//   failed pictures/CASE/NAME.png   what it drew; absent where nothing is drawn about.json               {"program":
//   "...", "version": "...", "data": "..."}: absent, or any of the three; results
//                            on other "data" are not compared

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::studies {

struct Results {
  std::filesystem::path folder;
  std::string program, version, data;
  std::vector<std::string> cases;                         // in the file's order, each once
  std::map<std::string, std::vector<double>> metrics;     // values in the order of cases; NaN: no number
  std::map<std::string, std::filesystem::path> pictures;  // by "CASE/NAME.png"
};

// Failures: "results-missing" (no metrics.csv), "results-invalid" (columns or cases twice, no case, a row too long).
Result<Results> read_results(const std::filesystem::path& folder);

}  // namespace glisson::studies
