#pragma once
// One step of a case's history, done to another case that is as it was before that step. What a hand drew or placed, or
// what came from outside, comes out the same, byte for byte.

#include <filesystem>

#include "casefile/case.h"

namespace glisson::casefile {

// `recorded_case` is the folder whose history holds the step of that number (macro.h names them); nothing in it
// changes. Fails with "step-unknown", or "step-changes-nothing" where it moved a view's value alone. Fails with
// "step-does-not-fit" where what it changed is not in `patient` as it was then. Fails with "step-content-gone" where
// another program has overwritten what the step led to. Fails with "history-damaged". Then `patient` is as it was.
Result<void> redo_step(Case& patient, const std::filesystem::path& recorded_case, int number);

}  // namespace glisson::casefile
