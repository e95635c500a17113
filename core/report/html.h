#pragma once
// A report as one HTML file that needs nothing beside it: styles and pictures are inside, no script, no network.

#include <filesystem>

#include "base/result.h"
#include "report/page.h"

namespace glisson::report {

// Fails with "file-not-readable" for a picture, "file-not-writable" for the page.
Result<void> write_html(const std::filesystem::path& file, const Page& page);

}  // namespace glisson::report
