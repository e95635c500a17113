#pragma once
// SIRGn's judgement on disk: a folder with quality.vtp and sirgn.json. The first is the correlation mesh; its point
// fields frame_000_mm, ... say where each point is in each frame. The second says what was judged, and the figures a
// frame.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

struct StoredQuality {
  std::filesystem::path sequence;  // the document that was judged
  std::string method;              // "icp", "geo", "gnra", "given"
  std::vector<double> tolerances_mm;
  Quality quality;  // mesh, correlation, error_mm, frames_seen, mesh_in_frames_mm, rmse_mm, tre_mm and mean_correlation
};

// "benchmark" or "own-landmarks".
[[nodiscard]] std::string_view judged_against(const Quality& quality);

// The folder is made where there is none. Failures: those of write_surface and write_json_file.
Result<void> write_quality(const std::filesystem::path& folder, const StoredQuality& stored);

// Failures: those of read_surface and read_json_file; "quality-invalid" (not what write_quality wrote).
Result<StoredQuality> read_quality(const std::filesystem::path& folder);

}  // namespace glisson::registration_quality
