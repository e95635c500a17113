#pragma once
// What closing the loop found, as a folder: report.json for programs, report.html for people, model.json, the better
// model, for prediction and rehearsal.

#include <filesystem>
#include <string>

#include "base/result.h"
#include "closedloop/explain.h"

namespace glisson::report {

// The folder is made where absent; files of these names are replaced, each whole. Fails with "file-not-writable".
Result<void> write_explanation(const std::filesystem::path& folder, const closedloop::Explained& explained);

}  // namespace glisson::report
