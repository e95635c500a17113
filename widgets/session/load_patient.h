#pragma once
// From a case folder, a study or the demo to a Patient: long work, called on a worker thread.

#include <functional>

#include "base/progress.h"
#include "base/result.h"
#include "casefile/import.h"
#include "imaging/study.h"
#include "widgets/session/patient.h"

namespace glisson::widgets {

// What a path that a person opened or dropped is.
enum class OpenedThing { case_folder, study };
[[nodiscard]] OpenedThing kind_of(const std::filesystem::path& path);

// Called, on the worker thread, with what can be shown already: images and structures, `preparing` set.
using FirstLook = std::function<void(const Patient&)>;

// Reads the case and, where it has a model, prepares the rehearsal (factorises, with the reference body (the atlas)).
// What was read is handed to `first_look` before the preparing, which takes seconds.
Result<Patient> load_patient(const std::filesystem::path& case_folder, const Progress& progress,
                             const FirstLook& first_look = {});

// Takes these series of a study, each in its role, into a case, which is made where it is not there yet; loads it. What
// is to be known of the labels stands in the patient's remarks.
Result<Patient> import_patient(const imaging::Study& study, const std::vector<casefile::SeriesRole>& roles,
                               const std::filesystem::path& case_folder, const Progress& progress,
                               casefile::Replacing replacing = casefile::Replacing::refused);

// What a case still lacks before a retraction can be rehearsed.
enum class NextStep { outline_liver, build_model, none };
[[nodiscard]] NextStep next_step(const std::filesystem::path& case_folder);

// Whether it holds raw elastography of which no stiffness was made yet.
[[nodiscard]] bool has_waves_to_invert(const std::filesystem::path& case_folder);

// Grows the liver from a point inside it; then the model: tetrahedra, and stiffness from MR elastography or, without
// it, from the atlas. Both load the case anew.
Result<Patient> outline_liver(const std::filesystem::path& case_folder, const Eigen::Vector3d& inside_mm,
                              const Progress& progress);
Result<Patient> build_model(const std::filesystem::path& case_folder, const Progress& progress);

// The demo patient in `folder`, made there the first time (minutes), opened from there later.
Result<Patient> load_demo(const std::filesystem::path& folder, const Progress& progress,
                          const FirstLook& first_look = {});

}  // namespace glisson::widgets
