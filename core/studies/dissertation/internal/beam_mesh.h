#pragma once
// Beams of tetrahedra for the studies.

#include <array>
#include <string>

#include "geometry/tetrahedra.h"

namespace glisson::studies {

// From the origin along x, y, z; bricks of six tetrahedra each (Kuhn's division, in which bricks fit each other).
[[nodiscard]] geometry::TetMesh beam_mesh(const std::array<int, 3>& bricks, const Eigen::Vector3d& size_mm);

// Adds a point array that is 1 on the end at x = 0.
void name_beam_end(geometry::TetMesh& beam, const std::string& array);

}  // namespace glisson::studies
