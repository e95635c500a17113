#pragma once
// Two studies compared (casefile/growth.h), as sentences, as a document and as a table.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/sentence.h"
#include "casefile/growth.h"

namespace glisson::report {

// What there is to say of liver and remnant, and of changes that may be none; remarks last.
[[nodiscard]] std::vector<Sentence> growth_sentences(const casefile::ComparedStudies& compared);

// `glisson-growth/1` (docs/file-formats.md); what is not known is left out.
[[nodiscard]] Json growth_json(const casefile::ComparedStudies& compared);

// A line a segment, then the remnant and the liver; empty where a figure is not known.
[[nodiscard]] std::string growth_table(const casefile::ComparedStudies& compared);

}  // namespace glisson::report
