#include "widgets/session/placed_landmarks.h"

#include <algorithm>

#include "casefile/placed_landmarks.h"
#include "mechanics/simulation.h"

namespace glisson::widgets {
namespace {

bool is_in_model(const rehearsal::RehearsalSetup& setup, const mechanics::Landmark& landmark) {
  return mechanics::locate_landmarks(setup.mesh, {landmark}, setup.landmark_tolerance_mm).has_value();
}

}  // namespace

Landmarks kept_landmarks(const std::filesystem::path& case_folder) {
  if (case_folder.empty()) return {};
  const auto opened = casefile::Case::open(case_folder);
  return opened ? casefile::placed_landmarks(*opened).value_or(Landmarks{}) : Landmarks{};
}

Result<Patient> with_kept_landmarks(Patient patient, const Landmarks& shown, const Progress& progress) {
  const auto opened = casefile::Case::open(patient.folder);
  if (!opened) return failure(opened.error());
  const auto kept = casefile::placed_landmarks(*opened);
  if (!kept) return failure(kept.error());
  patient.remarks.clear();
  if (patient.rehearsal_setup == nullptr) return patient;
  rehearsal::RehearsalSetup setup = *patient.rehearsal_setup;
  std::erase_if(setup.landmarks, [&](const mechanics::Landmark& landmark) {
    return std::any_of(shown.begin(), shown.end(), [&](const auto& placed) { return placed.id == landmark.id; });
  });
  for (const mechanics::Landmark& landmark : *kept) {
    if (is_in_model(setup, landmark)) setup.landmarks.push_back(landmark);
  }
  auto rehearsal = rehearsal::StaticRehearsal::create(setup, progress);
  if (!rehearsal) return failure(rehearsal.error());
  patient.rehearsal_setup = std::make_shared<rehearsal::RehearsalSetup>(std::move(setup));
  patient.rehearsal = std::make_shared<rehearsal::StaticRehearsal>(*std::move(rehearsal));
  return patient;
}

Result<Patient> with_landmarks(Patient patient, const Landmarks& shown, const Landmarks& wanted,
                               const Progress& progress) {
  for (const mechanics::Landmark& landmark : wanted) {
    if (patient.rehearsal_setup == nullptr || is_in_model(*patient.rehearsal_setup, landmark)) continue;
    return failure(Error{"landmark-off-liver",
                         GLISSON_TEXT("This place is not in the liver: a landmark is followed as the liver moves."),
                         {},
                         GLISSON_TEXT("Click in the liver, in a slice or in 3D, and set it again."),
                         {}});
  }
  auto opened = casefile::Case::open(patient.folder);
  if (!opened) return failure(opened.error());
  if (auto kept = casefile::keep_landmarks(*opened, wanted); !kept) return failure(kept.error());
  return with_kept_landmarks(std::move(patient), shown, progress);
}

}  // namespace glisson::widgets
