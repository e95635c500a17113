#pragma once
// The value beside SIRGn's own (sirgn.h, Quality::doubt_mm).

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

// placed_mm[landmark][frame]: where the registration put each sighting, in the model's space; landmarks are the mesh's
// points. Needs mesh, correlation and mesh_in_frames_mm. One value a triangle.
std::vector<double> doubt_mm(const Quality& quality,
                             const std::vector<std::vector<std::optional<Eigen::Vector3d>>>& placed_mm);

}  // namespace glisson::registration_quality
