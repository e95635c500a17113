#pragma once
// Real livers as a cohort's subjects: shape and vessels are the patients' own, the stiffness is drawn.

#include <filesystem>
#include <optional>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "studies/dissertation/subjects.h"

namespace glisson::studies {

// What everything that comes of such livers must say.
inline constexpr const char* drawn_stiffness_warning =
    "SIMULATED stiffness in real livers' shapes, drawn to the distributions of the dissertation";

// The label maps of a folder as shapes_livers (shapes_study.h) takes them, with ID_vessels.* beside where it is there.
// Fails with "shapes-no-livers".
Result<std::vector<Subject>> find_livers(const std::filesystem::path& folder, unsigned seed);

// The liver's outline (shapes/liver_outline.h) becomes voxels of 3 mm. Stiffness is drawn as simulated_liver_map does,
// from the seed and the liver's name alone. The landmarks are the forks of its vessels, in groups:
//   forks                        all of 3 mm calibre and more (vasculature/forks.h) that lie in the liver
//   portal_forks, hepatic_forks  by the system that explain_vessels (vasculature/couinaud.h) gives them
//   wide_forks, narrow_forks     of 6 mm calibre and more, and of less
// Without a vessel mask there are none. Fails as outline_of, center_lines and explain_vessels do, and with
// "shapes-cut-off" where the image ends before the liver does.
Result<MeasuredLiver> read_liver(const Subject& subject);

// The outline of its vessels, for pictures; nothing without a vessel mask. Fails where that cannot be read.
Result<std::optional<geometry::Surface>> vessels_of(const Subject& subject);

}  // namespace glisson::studies
