#pragma once
// Accepted evidence, as several commands answer it.

#include "base/json.h"
#include "casefile/evidence.h"

namespace glisson::cli {

Json evidence_json(const casefile::Evidence& evidence);
std::string evidence_text(const casefile::Evidence& evidence);

}  // namespace glisson::cli
