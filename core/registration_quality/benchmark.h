#pragma once
// What a registration is judged against, whatever algorithm it is: the global alignment of all frames by their
// landmarks (GNRA; section 2.2.1 of the dissertation: ALG, M and S). On disk it is a table,
// landmark,frame,x_mm,y_mm,z_mm. There `frame` is "model" for the landmark's place on M, and a number for where S^-1
// has that place in the frame.

#include <filesystem>

#include "base/result.h"
#include "registration/global_alignment.h"
#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

// Each landmark's place and S^-1 of it, by Newton's method from the frame's rigid motion; to 1e-3 mm, or nothing.
[[nodiscard]] Benchmark benchmark_of(const registration::GlobalAlignment& alignment);

// `landmarks` say the order. Failures: those of write_text_file.
Result<void> write_benchmark(const std::filesystem::path& file, const std::vector<LandmarkTrack>& landmarks,
                             const Benchmark& benchmark);

// Failures: file-not-readable; "benchmark-invalid" (which line; a landmark that the tracks do not have).
Result<Benchmark> read_benchmark(const std::filesystem::path& file, const std::vector<LandmarkTrack>& landmarks,
                                 std::size_t frames);

}  // namespace glisson::registration_quality
