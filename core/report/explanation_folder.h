#pragma once
// What closing the loop found, as a folder: report.json for programs, report.html for people, model.json, the better
// model, for prediction and rehearsal; of elastography also maps of where the law does not hold
// (closedloop/where_it_holds.h).

#include <filesystem>
#include <string>

#include "base/result.h"
#include "closedloop/explain.h"
#include "report/words.h"

namespace glisson::report {

// The folder is made where absent, and files of these names are replaced, each whole. How probabilities went since
// trials were fewer is taken over from a report that is there (closedloop/posterior_history.h). The page speaks
// `words`; the files for programs speak English. Fails with "file-not-writable".
Result<void> write_explanation(const std::filesystem::path& folder, const closedloop::Explained& explained,
                               const Words& words = {});

}  // namespace glisson::report
