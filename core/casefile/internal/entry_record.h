#pragma once
// An entry of a case as it stands in case.json.

#include <string>
#include <string_view>

#include "casefile/case.h"

namespace glisson::casefile {

// One JSON object as text.
[[nodiscard]] std::string record_of(const Entry& entry);

// A case may come from anywhere. Fails with "case-invalid" where `text` is no entry, and with "case-path-outside" where
// it names a file outside the case folder. `file` is where the text came from.
[[nodiscard]] Result<Entry> entry_of(std::string_view text, const std::filesystem::path& file);

}  // namespace glisson::casefile
