#pragma once
// Two studies compared, as a page, and all that is written of them.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "casefile/growth.h"
#include "report/page.h"

namespace glisson::report {

// `origin`: "SIMULATED ...", or empty for a real patient.
[[nodiscard]] Page growth_page(const casefile::ComparedStudies& compared, const std::string& origin);

// growth.json, growth.csv and growth.html, all or none; answers with the files.
Result<std::vector<std::filesystem::path>> write_growth(const std::filesystem::path& folder,
                                                        const casefile::ComparedStudies& compared,
                                                        const std::string& origin);

}  // namespace glisson::report
