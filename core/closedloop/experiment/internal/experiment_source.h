#pragma once
// What the three readers of experiments share. Their refusals (base/json_reading.h) end in read_experiment.

#include <filesystem>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/json_reading.h"
#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

// The document being read, and where its parts stand in it.
struct Source {
  std::filesystem::path file;
  std::string text;

  // The line, from 1, on which `quoted` first stands in quotes; 1 where it does not.
  [[nodiscard]] std::size_t line_of(const std::string& quoted) const;
  // A file that the document names, beside it. Refused where it is not there.
  [[nodiscard]] std::filesystem::path named_file(const std::string& name) const;
};

// The list under "trials": not empty, of objects with ids that differ.
std::vector<std::string> trial_ids(const Json& json);

// One column of a table: no cell without a number. `file` and `key` are named in refusals.
Eigen::VectorXd column_of(const CsvTable& table, const std::string& column, const std::filesystem::path& file,
                          const std::string& key);
// The same for times, which must not go back.
Eigen::VectorXd times_of(const CsvTable& table, const std::string& column, const std::filesystem::path& file);
CsvTable table_of(const std::filesystem::path& file);

// A modulus that no tissue and no phantom has was given in another unit.
void refuse_unlikely_modulus(double young_kPa, const std::string& where);

Palpation palpation_from(const Json& json, const Source& source, Needs needs);
Material material_from(const Json& json, const Source& source, Needs needs);
Platform platform_from(const Json& json, const Source& source, Needs needs);

}  // namespace glisson::closedloop
