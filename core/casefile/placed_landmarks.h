#pragma once
// Points with names that somebody set on the patient by hand, kept in the case as "landmarks/placed".
//
//   landmarks/placed.json   {"format": "glisson-landmarks/1", "landmarks": [{"name": "...", "position_mm": [x, y, z]}]}
//
// Positions are where the scan shows them: patient LPS, mm. They move with the liver as the structures' own points do.

#include <string>
#include <string_view>
#include <vector>

#include "casefile/case.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::casefile {

// None where none was set. Fails with "landmarks-invalid" (which file, and what about it).
Result<std::vector<mechanics::Landmark>> placed_landmarks(const Case& patient);

// Keeps these and no others; none takes the entry away. Names must be valid and all different (asserts).
Result<void> keep_landmarks(Case& patient, const std::vector<mechanics::Landmark>& landmarks);

// Lower-case letters, digits and hyphens, as structures are called; empty where nothing of it remains.
[[nodiscard]] std::string landmark_name(std::string_view typed);

}  // namespace glisson::casefile
