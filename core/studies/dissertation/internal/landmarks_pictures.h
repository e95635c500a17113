#pragma once
// Pictures of single patients for the landmark studies' report (dissertation, figures 4.12 and 4.14).

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "studies/dissertation/internal/landmarks_report.h"
#include "studies/dissertation/subjects.h"

namespace glisson::studies {

// Pictures go into out/examples/ID. LandmarksOptions::pictures patients, from the median one to the extremes, get
// atlas-and-mre.png and the two results. Up to three patients get beams.png: those in whom one region's beam is less
// than 5 mm from the control and the others are not. Fails as retract, compare_beams and drawing do.
Result<LandmarksPictures> draw_landmarks_pictures(const std::vector<Subject>& subjects,
                                                  const std::filesystem::path& out, const LandmarksSummary& summary,
                                                  const LandmarksOptions& options);

}  // namespace glisson::studies
