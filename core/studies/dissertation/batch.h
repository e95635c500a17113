#pragma once
// A computation over many patients that can be stopped and taken up again: each patient's row is a file of its own, and
// one that fails does not stop the rest. Processes that share the folder may each take other patients.

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::studies {

struct BatchPatient {
  std::string id;           // serves as a file name
  std::string fingerprint;  // of what the row depends on: input and options. A row made from another is made again
};

using NamedNumbers = std::vector<std::pair<std::string, double>>;

struct BatchRow {
  std::string id;
  NamedNumbers values;  // empty where it failed; a patient may lack what others have
  std::string error;    // one sentence; empty where it did not
  bool reused = false;  // from an earlier run
};

// Rows in the order of the patients. Those that lie in out/patients/ID.json, whole and with the same fingerprint, are
// reused; those that failed are tried again. With `only` no other patient is computed, and rows that are not there yet
// are left out. Fails with "batch-unknown-patient", "batch-no-patients", with "cancelled" (rows that are done stay), or
// where the folder cannot be written.
Result<std::vector<BatchRow>> run_batch(const std::filesystem::path& out, const std::vector<BatchPatient>& patients,
                                        const std::function<Result<NamedNumbers>(std::size_t patient)>& compute,
                                        const std::optional<std::string>& only = {}, const Progress& progress = {});

// What lies in out/patients, whoever computes it, in the order of names: none of `but_not`, and none that is damaged or
// under way. An empty or missing folder has none.
[[nodiscard]] std::vector<BatchRow> rows_in(const std::filesystem::path& out,
                                            const std::set<std::string>& but_not = {});

// A header and a line a row: patient, the values of all names that any row has, error.
Result<void> write_batch_csv(const std::filesystem::path& file, const std::vector<BatchRow>& rows);

// The column of that name over the rows that have it.
[[nodiscard]] std::vector<double> column_of(const std::vector<BatchRow>& rows, const std::string& name);

}  // namespace glisson::studies
