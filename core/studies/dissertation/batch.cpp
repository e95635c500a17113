#include "studies/dissertation/batch.h"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/files.h"
#include "base/json_value.h"
#include "base/parallel.h"
#include "studies/dissertation/internal/chunk_file.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

fs::path row_file(const fs::path& out, const std::string& id) { return out / "patients" / (id + ".json"); }

// Nothing where there is none, or where it is damaged.
std::optional<BatchRow> row_of(const Result<Json>& document, const std::string& id) {
  if (!document) return std::nullopt;
  BatchRow row{id, {}, string_in(*document, "error").value_or(""), true};
  const Json* values = value_in(*document, "values");
  if (values == nullptr || !values->is_object()) return std::nullopt;
  for (const auto& [name, value] : values->items()) {
    if (value.is_number()) row.values.emplace_back(name, value.get<double>());
  }
  return row;
}

// A row that can be believed: one made from other input cannot. Those in chunks may come from nobody's patients.
std::optional<BatchRow> finished_row(const fs::path& out, const std::map<std::string, StoredRow>& chunks,
                                     const BatchPatient& patient) {
  std::error_code problem;
  if (fs::exists(row_file(out, patient.id), problem)) {
    const auto document = read_json_file(row_file(out, patient.id));
    if (document && says(*document, "fingerprint", patient.fingerprint)) return row_of(document, patient.id);
  }
  const auto stored = chunks.find(patient.id);
  if (stored == chunks.end() || stored->second.fingerprint != patient.fingerprint) return std::nullopt;
  return stored->second.row;
}

Result<void> save_row(const fs::path& out, const BatchPatient& patient, const BatchRow& row) {
  Json document{{"patient", row.id}, {"fingerprint", patient.fingerprint}, {"values", Json::object()}};
  for (const auto& [name, value] : row.values) document["values"][name] = value;
  if (!row.error.empty()) document["error"] = row.error;
  return write_json_file(row_file(out, patient.id), document);
}

BatchRow computed_row(const BatchPatient& patient, const Result<NamedNumbers>& values) {
  if (!values) return {patient.id, {}, values.error().message(), false};
  for (const auto& [name, value] : *values) {
    if (!std::isfinite(value)) return {patient.id, {}, fmt::format("{} is not a number.", name), false};
  }
  return {patient.id, *values, {}, false};
}

fs::path chunk_file(const fs::path& out, const BatchPart& part) {
  return out / "chunks" / fmt::format("{}-of-{}.json", part.chunk, part.chunks);
}

// From the first of the patients to past the last; nothing where a patient is named whom nobody knows.
std::optional<std::pair<std::size_t, std::size_t>> range_of(const BatchPart& part,
                                                            const std::vector<BatchPatient>& patients) {
  if (part.patient) {
    const auto named = [&](const BatchPatient& patient) { return patient.id == *part.patient; };
    const auto found = std::find_if(patients.begin(), patients.end(), named);
    if (found == patients.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(found - patients.begin());
    return std::pair(at, at + 1);
  }
  if (part.chunks == 0) return std::pair(std::size_t{0}, patients.size());
  GLISSON_ASSERT(1 <= part.chunk && part.chunk <= part.chunks);
  const auto bound = [&](int chunk) {
    return patients.size() * static_cast<std::size_t>(chunk) / static_cast<std::size_t>(part.chunks);
  };
  return std::pair(bound(part.chunk - 1), bound(part.chunk));
}

std::string csv_text(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

Result<std::vector<BatchRow>> run_batch(const fs::path& out, const std::vector<BatchPatient>& patients,
                                        const std::function<Result<NamedNumbers>(std::size_t patient)>& compute,
                                        const BatchPart& part, const Progress& progress) {
  if (patients.empty()) return failure("batch-no-patients", GLISSON_TEXT("There are no patients in this cohort."));
  const auto range = range_of(part, patients);
  if (!range) return failure("batch-unknown-patient", GLISSON_TEXT("The cohort has no patient {0}."), {*part.patient});
  const std::size_t first = range->first, past = range->second;
  const bool in_chunk = part.chunks > 0;
  std::error_code problem;
  fs::create_directories(out / (in_chunk ? "chunks" : "patients"), problem);
  const std::map<std::string, StoredRow> chunks = rows_in_chunks(out / "chunks");
  std::vector<std::optional<BatchRow>> rows(past - first);
  std::mutex reporting;
  std::optional<Error> not_saved;
  std::size_t done = 0;
  std::size_t made = 0;
  parallel_for(rows.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const BatchPatient& patient = patients[first + n];
      rows[n] = finished_row(out, chunks, patient);
      if ((!rows[n] || !rows[n]->error.empty()) && !progress.cancelled()) {
        const Result<NamedNumbers> values = compute(first + n);
        if (!values && values.error().code == "cancelled") continue;
        if (!values && values.error().code == "file-not-writable") {  // the disk's fault, and no patient's
          const std::lock_guard lock(reporting);
          not_saved = values.error();
          continue;
        }
        rows[n] = computed_row(patient, values);
        const auto saved = in_chunk ? Result<void>() : save_row(out, patient, *rows[n]);
        const std::lock_guard lock(reporting);
        ++made;
        if (!saved) not_saved = saved.error();
      }
      const std::lock_guard lock(reporting);
      progress.report(static_cast<double>(++done) / static_cast<double>(rows.size()),
                      std::string(GLISSON_TEXT("Patient")) + ": " + patient.id);
    }
  });
  if (not_saved) return failure(*not_saved);
  if (progress.cancelled()) return cancelled();
  std::vector<BatchRow> finished;
  for (auto& row : rows) {
    if (row) finished.push_back(std::move(*row));
  }
  const fs::path file = chunk_file(out, part);
  if (in_chunk && (made > 0 || !fs::exists(file, problem))) {
    const std::vector<BatchPatient> whose(patients.begin() + static_cast<std::ptrdiff_t>(first),
                                          patients.begin() + static_cast<std::ptrdiff_t>(past));
    if (auto saved = write_chunk(file, whose, finished); !saved) return failure(saved.error());
  }
  return finished;
}

std::vector<BatchRow> rows_in(const fs::path& out, const std::set<std::string>& but_not) {
  std::vector<BatchRow> rows;
  std::error_code problem;
  for (fs::directory_iterator entry(out / "patients", problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::string id = entry->path().stem().string();
    if (entry->path().extension() != ".json" || but_not.count(id) > 0) continue;
    if (auto row = row_of(read_json_file(entry->path()), id)) rows.push_back(std::move(*row));
  }
  std::set<std::string> known = but_not;
  for (const BatchRow& row : rows) known.insert(row.id);
  for (auto& [id, stored] : rows_in_chunks(out / "chunks"))
    if (!known.contains(id)) rows.push_back(std::move(stored.row));
  std::sort(rows.begin(), rows.end(), [](const BatchRow& a, const BatchRow& b) { return a.id < b.id; });
  return rows;
}

Result<void> write_batch_csv(const fs::path& file, const std::vector<BatchRow>& rows, std::string_view without) {
  std::vector<std::string> names;
  for (const BatchRow& row : rows) {
    for (const auto& [name, value] : row.values) {
      if (name != without && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::string text = "patient";
  for (const std::string& name : names) text += "," + name;
  text += ",error\n";
  for (const BatchRow& row : rows) {
    text += csv_text(row.id);
    for (const std::string& name : names) {
      const auto of_name = [&](const auto& value) { return value.first == name; };
      const auto value = std::find_if(row.values.begin(), row.values.end(), of_name);
      text += value == row.values.end() ? "," : fmt::format(",{:.6g}", value->second);
    }
    text += "," + csv_text(row.error) + "\n";
  }
  return write_text_file(file, text);
}

std::vector<double> column_of(const std::vector<BatchRow>& rows, const std::string& name) {
  std::vector<double> column;
  for (const BatchRow& row : rows) {
    for (const auto& [known, value] : row.values) {
      if (known == name) column.push_back(value);
    }
  }
  return column;
}

}  // namespace glisson::studies
