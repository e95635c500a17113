#pragma once
// What `study palpation` writes beside the rows.

#include <filesystem>

#include "base/result.h"
#include "studies/dissertation/palpation.h"

namespace glisson::studies {

// palpation.csv, summary.json and report.html, as tables 4.2 to 4.4 lay it out. Failures: "file-not-writable".
Result<void> write_palpation(const std::filesystem::path& out, const PalpationSummary& summary,
                             const PalpationOptions& options);

}  // namespace glisson::studies
