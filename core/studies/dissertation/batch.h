#pragma once
// A computation over many patients that can be stopped and taken up again. Each patient's row is a file of its own, or
// one of a chunk's. One that fails does not stop the rest. Processes that share the folder may each take another part.

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
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

// What one job of many computes: everybody, one patient, or the chunk-th of `chunks` runs. The runs are of patients
// that follow each other, and as long as each other, or longer by one.
struct BatchPart {
  std::optional<std::string> patient;
  int chunk = 0, chunks = 0;  // 1 <= chunk <= chunks; 0: no chunk
  [[nodiscard]] bool is_all() const { return !patient && chunks == 0; }
};

// Rows of the part in the order of the patients. Those that lie in `out`, whole and with the same fingerprint, are
// reused; those that failed are tried again. A row is out/patients/ID.json as soon as it is made. The rows of a chunk
// are columns of out/chunks/K-of-N.json as soon as all of them are made. So a chunk that is stopped begins again. Fails
// with "batch-unknown-patient", "batch-no-patients", or "cancelled" (rows that are written stay). Fails with
// "file-not-writable" where the disk takes no row, or nothing of what is computed beside it.
Result<std::vector<BatchRow>> run_batch(const std::filesystem::path& out, const std::vector<BatchPatient>& patients,
                                        const std::function<Result<NamedNumbers>(std::size_t patient)>& compute,
                                        const BatchPart& part = {}, const Progress& progress = {});

// What lies in out/patients and out/chunks, whoever computes it, in the order of names: none of `but_not`, and none
// that is damaged or under way. An empty or missing folder has none.
[[nodiscard]] std::vector<BatchRow> rows_in(const std::filesystem::path& out,
                                            const std::set<std::string>& but_not = {});

// A header and a line a row: patient, the values of all names that any row has but `without`, error. What differs from
// run to run, as a time, is left out, so that the same rows give the same bytes.
Result<void> write_batch_csv(const std::filesystem::path& file, const std::vector<BatchRow>& rows,
                             std::string_view without = {});

// The column of that name over the rows that have it.
[[nodiscard]] std::vector<double> column_of(const std::vector<BatchRow>& rows, const std::string& name);

}  // namespace glisson::studies
