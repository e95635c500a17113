#pragma once
// Small values of the history as commands: tools of a rehearsal, cuts of a plan in the making, the liver laid by hand
// on a frame.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "casefile/internal/history_journal.h"
#include "casefile/macro.h"

namespace glisson::casefile {

// Fills in those of its steps, which are the listing's that are done, that are about values.
void add_commands_of_values(const std::filesystem::path& case_folder, const Listing& listing, Macro& macro);

// A document without true, false and null reads the same in Python.
[[nodiscard]] std::string in_python(const Json& json);
[[nodiscard]] std::string in_python(const std::string& text);

}  // namespace glisson::casefile
