#pragma once
// Where a body touches itself in a point or an edge only, its surface is no manifold and its mechanics no solid's.

#include <cstddef>

#include "geometry/tetrahedra.h"

namespace glisson::meshing {

// Takes away the fewest cells found that leave one part whose surface is a watertight manifold. At each pinch all cells
// go but the largest group that hangs together by faces there. At the end all go but the largest part. Returns how many
// cells went.
std::size_t remove_pinches(geometry::TetMesh& mesh);

}  // namespace glisson::meshing
