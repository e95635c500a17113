#pragma once
// The page of a review: two pictures side by side, a timeline under them, the figures of each frame as curves.

#include <filesystem>

#include "quality/quality_file.h"

namespace glisson::study {

// Shows a000.jpg, b000.jpg, ... that lie beside it. One file, with a few lines of script and no network.
Result<void> write_review_page(const std::filesystem::path& file, const quality::StoredQuality& a,
                               const quality::StoredQuality& b, double tolerance_mm);

}  // namespace glisson::study
