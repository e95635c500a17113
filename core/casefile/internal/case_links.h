#pragma once
// A case from somewhere else may hold a folder that is a link: what is written there would land outside of the case.

#include <filesystem>

#include "base/result.h"

namespace glisson::casefile {

// Fails with "case-link" where a folder on the way from the case to `file`, a path inside of it, is a link.
Result<void> refuse_links(const std::filesystem::path& case_folder, const std::filesystem::path& file);

// The same of a folder for files, wherever it lies: of each case that it lies in, none outside of them.
Result<void> refuse_links_on_the_way_to(const std::filesystem::path& folder);

}  // namespace glisson::casefile
