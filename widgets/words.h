#pragma once
// Sentences of the core as a person reads them: translated, with their figures filled in.

#include <QString>
#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::widgets {

// The sentences stand in the core, marked GLISSON_TEXT; the translations know them under the context "errors".
[[nodiscard]] QString told(const std::string& sentence, const std::vector<std::string>& arguments);

// The sentence, the file, then what to do.
[[nodiscard]] QString told(const Error& error);

}  // namespace glisson::widgets
