#pragma once
// The page of a review: two pictures side by side, a timeline under them, the figures of each frame as curves.

#include <filesystem>

#include "registration_quality/quality_file.h"

namespace glisson::studies {

// Shows a000.jpg, b000.jpg, ... that lie beside it. One file, with a few lines of script and no network.
Result<void> write_review_page(const std::filesystem::path& file, const registration_quality::StoredQuality& a,
                               const registration_quality::StoredQuality& b, double tolerance_mm);

}  // namespace glisson::studies
