#pragma once
// Sections of the patient's page that read more of the case than its list of files.

#include "base/result.h"
#include "casefile/case.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

Result<void> add_model(Page& page, const casefile::Case& patient, const Words& words);
void add_resection(Page& page, const casefile::Case& patient, const Words& words);
// The plans that are kept, side by side; nothing where there is none.
Result<void> add_kept_plans(Page& page, const casefile::Case& patient, const Words& words);
// The orders of steps that were compared last; nothing where none were.
Result<void> add_orders(Page& page, const casefile::Case& patient, const Words& words);
Result<void> add_evidence(Page& page, const casefile::Case& patient, const Words& words);

}  // namespace glisson::report
