#pragma once
// What the three readers of experiments share. Inside them refusals travel as exceptions, so that each can simply give
// back its value; read_experiment turns them into Errors.

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/csv.h"
#include "base/json.h"
#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop {

struct Refusal {
  Error error;
};

// `text` has {0}, {1}, ... for `arguments`; `cause` is what to look at first.
[[noreturn]] void refuse(std::string code, std::string text, std::vector<std::string> arguments, std::string cause = {},
                         std::filesystem::path file = {});

// The document being read, and where its parts stand in it.
struct Source {
  std::filesystem::path file;
  std::string text;

  // The line, from 1, on which `quoted` first stands in quotes; 1 where it does not.
  [[nodiscard]] std::size_t line_of(const std::string& quoted) const;
  // A file that the document names, beside it. Refused where it is not there.
  [[nodiscard]] std::filesystem::path named_file(const std::string& name) const;
};

// Readers of one value; `where` is how a person would find it ("trial p01, tool").
void only_keys(const Json& json, std::initializer_list<std::string_view> known, const std::string& where);
const Json& required(const Json& json, const char* key, const std::string& where);
double number_in(const Json& json, const std::string& where);
double positive_in(const Json& json, const std::string& where);
std::string text_in(const Json& json, const std::string& where);
Eigen::Vector3d vector_in(const Json& json, const std::string& where);
std::optional<double> optional_positive(const Json& json, const char* key, const std::string& where);

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
