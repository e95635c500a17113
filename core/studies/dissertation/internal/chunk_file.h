#pragma once
// Rows of a chunk of patients, as columns of one file: a study of ten thousand patients is some hundred files, not ten
// thousand.
//
//   {"format": "glisson-rows/1", "made_by": "Glisson 1.0", "patients": ["p1", "p2"], "fingerprints": ["...", "..."],
//    "values": {"mean_kPa": [2.1, null]}, "errors": [null, "The map has no voxels."]}

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

struct StoredRow {
  std::string fingerprint;
  BatchRow row;
};

// Of equally many patients and rows, whole or not at all; the same rows give the same bytes.
Result<void> write_chunk(const std::filesystem::path& file, const std::vector<BatchPatient>& patients,
                         const std::vector<BatchRow>& rows);

// Of all chunks in a folder, by patient. A file that is damaged or of another format counts as not there. Of two rows
// of one patient the one in the later name counts. No folder: no rows.
[[nodiscard]] std::map<std::string, StoredRow> rows_in_chunks(const std::filesystem::path& folder);

}  // namespace glisson::studies
