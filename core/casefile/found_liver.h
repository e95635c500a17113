#pragma once
// The liver of a case found by brightness and shape together.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/structures.h"
#include "segmentation/taken_off.h"

namespace glisson::casefile {

// In place of a file: a model of nobody's (shapes/smooth_model.h).
inline constexpr const char* simulated_shapes = "simulated";

// Finds the liver on volumes/anatomy (shapes/find_liver.h) from points inside and outside it (patient LPS, mm), or from
// none, and saves it as the structure "liver". `shapes` is a model's file (shapes/model_file.h), or "simulated". Fails
// as read_model() and find_liver() do.
Result<SavedStructure> find_liver(Case& patient, const segmentation::GivenPoints& points = {},
                                  const std::string& shapes = simulated_shapes, const Progress& progress = {});

}  // namespace glisson::casefile
