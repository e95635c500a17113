#pragma once
// The pictures of a case and of a simulation's result, by name: what `glisson-cli render` and the reports draw.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "casefile/case.h"
#include "scene/composite.h"
#include "scene/scene.h"

namespace glisson::scene {

// Of a case:
//   anatomy      a transverse slice through the middle of the liver, with the structures' outlines
//   liver        the liver as glass, with the tumours and vessels inside it, from the surgeon's side
//   stiffness    the measured shear stiffness in the same slice, with the liver's outline
//   model        the liver's surface coloured by the Young's modulus of the cells behind it
// Of a case whose waves were inverted, besides:
//   waves        the shear waves in that slice at one instant
//   confidence   how far the stiffness map is to be believed, 0 to 1
// Of a case with a planned resection, besides:
//   resection    the liver as glass with its tumours and vessels, and the cut
// Of a result (a folder with result.vtu, inside a case's results/ or anywhere):
//   displacement the moved liver coloured by how far each point moved, with the tool's force and the landmarks
[[nodiscard]] const std::vector<std::string>& case_scene_names();  // those that every finished case has
[[nodiscard]] const std::vector<std::string>& wave_scene_names();
inline constexpr const char* resection_scene_name = "resection";

// Fails with "scene-unknown" (the names are listed), or where the case lacks what the scene shows.
Result<Scene> case_scene(const casefile::Case& patient, const std::string& name);
Result<Scene> result_scene(const std::filesystem::path& result_folder);

// Two results of one model in one picture, red and blue.
Result<Comparison> comparison_scene(const std::filesystem::path& in_red, const std::string& red_label,
                                    const std::filesystem::path& in_blue, const std::string& blue_label);

// The warning that every picture of the case must carry; empty for a real patient.
[[nodiscard]] std::string warning_of(const casefile::Case& patient);

}  // namespace glisson::scene
