#pragma once
// Sections of the patient's page that read more of the case than its list of files. Inside the room.

#include "base/result.h"
#include "casefile/case.h"
#include "report/page.h"

namespace glisson::report {

Result<void> add_model(Page& page, const casefile::Case& patient);
void add_resection(Page& page, const casefile::Case& patient);
Result<void> add_evidence(Page& page, const casefile::Case& patient);

}  // namespace glisson::report
