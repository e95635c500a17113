#pragma once
// Landmarks that somebody set by hand, in the case and in the rehearsal: nothing is factorised anew for them.

#include <vector>

#include "base/progress.h"
#include "mechanics/scenario/scenario.h"
#include "widgets/session/patient.h"

namespace glisson::widgets {

using Landmarks = std::vector<mechanics::Landmark>;

// Those that the case holds now; none where it holds none, or they cannot be read.
[[nodiscard]] Landmarks kept_landmarks(const std::filesystem::path& case_folder);

// The patient with the landmarks that the case holds now; `shown` are those that its rehearsal has of them so far.
Result<Patient> with_kept_landmarks(Patient patient, const Landmarks& shown, const Progress& progress);

// Keeps these and no others in the case first. Fails with "landmark-off-liver" where one lies outside of the model.
Result<Patient> with_landmarks(Patient patient, const Landmarks& shown, const Landmarks& wanted,
                               const Progress& progress);

}  // namespace glisson::widgets
