#pragma once
// Two registrations of one video side by side: their heat meshes over every frame in one colour scale, with a timeline.

#include <array>
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "registration_quality/quality_file.h"

namespace glisson::studies {

enum class ReviewedValue { correlation, error };

struct ReviewOptions {
  ReviewedValue value = ReviewedValue::correlation;
  double tolerance_mm = 5;  // triangles that are off by as much are grey
};

struct Review {
  int frames = 0;
  std::array<double, 2> range{0, 1};  // of the shared colour scale
  std::filesystem::path page;
};

// Pictures of one registration, folder/f000.jpg and so on. The scale of correlation is 0 to 1, so that pictures of any
// two can be laid side by side. That of the error is 0 to twice the tolerance. Returns how many. Failures:
// "review-no-camera" or "review-no-images" (the sequence names none), those of read_sequence, read_frame and
// write_frame.
Result<int> write_heat_pictures(const registration_quality::StoredQuality& judged, const std::filesystem::path& folder,
                                const ReviewOptions& options = {}, const Progress& progress = {});

// Writes folder/review.html and the pictures that it shows. Failures: those above; "review-different-videos" (the two
// do not judge the same number of frames of one sequence).
Result<Review> write_review(const registration_quality::StoredQuality& a, const registration_quality::StoredQuality& b,
                            const std::filesystem::path& folder, const ReviewOptions& options = {},
                            const Progress& progress = {});

}  // namespace glisson::studies
