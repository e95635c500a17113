#pragma once
// A simulation's outcome as files: DIR/result.vtu is the rest mesh with the point array displacement_mm and its cell
// fields. DIR/result.json says what was reached, what it is worth, and the landmarks. An unusable answer has no
// displacements there. DIR/scenario.json is the question, in full.

#include <filesystem>
#include <optional>

#include "base/json_forward.h"
#include "base/result.h"
#include "mechanics/simulation.h"
#include "rehearsal/comparison.h"

namespace glisson::casefile {

// The folder is made where absent; files of these names are replaced, each whole. Fails with "case-link" where a link
// leads out of the case that the folder lies in.
Result<void> write_result(const std::filesystem::path& folder, const mechanics::Simulation& simulation);

// Fails with "not-a-result", naming what is missing or damaged, and where the answer may not be used.
Result<rehearsal::ComparedResult> read_result(const std::filesystem::path& folder);

// What the result in that folder is worth; nothing where there is no result.json. Fails where that is no JSON.
Result<std::optional<mechanics::Validity>> read_validity(const std::filesystem::path& folder);

// The summary that `simulate --json` prints and result.json holds.
[[nodiscard]] Json result_json(const mechanics::Simulation& simulation);

}  // namespace glisson::casefile
