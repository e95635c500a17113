#pragma once
// What a scanner beside the phantom sees of it, and how far that lies from a simulated surface (section 4.5).

#include <filesystem>

#include "base/result.h"
#include "studies/dissertation/batch.h"
#include "studies/dissertation/internal/palpation_model.h"
#include "studies/dissertation/internal/revolved_press.h"

namespace glisson::studies {

struct PalpationScans {
  geometry::Surface rest, pressed;  // mm, in the scanner's own frame
};

// SIMULATED scans of what is true, turned about the axis: from one side, with the ball in the way, 0.1 mm of noise, and
// from a rough placement by hand, 5 degrees and 7 mm off.
[[nodiscard]] PalpationScans simulated_scans(const std::vector<Eigen::Vector2d>& rest_profile_mm,
                                             const PressedProfile& pressed, double ball_radius_mm, unsigned seed);

// FOLDER/A-rest.ply and FOLDER/A-1.69N.ply. Failures: read_surface's.
Result<PalpationScans> scans_in(const std::filesystem::path& folder, const std::string& phantom,
                                const std::string& trial);

// The scan at rest is aligned with the model at rest by ICP, and the other scan moves with it. Gives mean_mm, rms_mm,
// max_mm, near_tool_mm (on the top within twice the ball's radius), alignment_mm, scan_points. Failures: rigid_icp's.
Result<NamedNumbers> compare(const PressedPhantom& model, const PalpationScans& scans, double ball_radius_mm);

}  // namespace glisson::studies
