#include "studies/dissertation/internal/chunk_file.h"

#include <algorithm>
#include <set>

#include "base/files.h"
#include "base/json_value.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

constexpr const char* format = "glisson-rows/1";

// Nothing where any of it is not as write_chunk() writes it.
std::vector<StoredRow> rows_of(const Json& document) {
  const Json* patients = value_in(document, "patients");
  const Json* fingerprints = value_in(document, "fingerprints");
  const Json* errors = value_in(document, "errors");
  const Json* values = value_in(document, "values");
  if (!says(document, "format", format) || values == nullptr || !values->is_object()) return {};
  const auto lists_all = [&](const Json* list) {
    return list != nullptr && list->is_array() && list->size() == patients->size();
  };
  if (patients == nullptr || !lists_all(patients) || !lists_all(fingerprints) || !lists_all(errors)) return {};
  std::vector<StoredRow> rows;
  for (std::size_t n = 0; n < patients->size(); ++n) {
    const Json &id = (*patients)[n], &fingerprint = (*fingerprints)[n], &error = (*errors)[n];
    if (!id.is_string() || !fingerprint.is_string()) return {};
    const std::string said = error.is_string() ? error.get<std::string>() : "";
    rows.push_back({fingerprint.get<std::string>(), {id.get<std::string>(), {}, said, true}});
  }
  for (const auto& [name, column] : values->items()) {
    if (!lists_all(&column)) return {};
    for (std::size_t n = 0; n < rows.size(); ++n)
      if (column[n].is_number()) rows[n].row.values.emplace_back(name, column[n].get<double>());
  }
  return rows;
}

}  // namespace

Result<void> write_chunk(const fs::path& file, const std::vector<BatchPatient>& patients,
                         const std::vector<BatchRow>& rows) {
  GLISSON_ASSERT(patients.size() == rows.size());
  Json document{{"format", format},          {"made_by", "Glisson " + version()},
                {"patients", Json::array()}, {"fingerprints", Json::array()},
                {"values", Json::object()},  {"errors", Json::array()}};
  Json& values = document["values"];
  for (std::size_t n = 0; n < rows.size(); ++n) {
    document["patients"].push_back(rows[n].id);
    document["fingerprints"].push_back(patients[n].fingerprint);
    document["errors"].push_back(rows[n].error.empty() ? Json() : Json(rows[n].error));
    for (const auto& [name, value] : rows[n].values) {
      if (!values.contains(name)) values[name] = std::vector<Json>(rows.size());
      values[name][n] = value;
    }
  }
  return write_text_file(file, document.dump() + "\n");
}

std::map<std::string, StoredRow> rows_in_chunks(const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem))
    if (entry->path().extension() == ".json") files.insert(entry->path());
  std::map<std::string, StoredRow> rows;
  for (const fs::path& file : files) {
    const auto document = read_json_file(file);
    if (!document) continue;
    for (StoredRow& row : rows_of(*document)) rows[row.row.id] = std::move(row);
  }
  return rows;
}

}  // namespace glisson::studies
