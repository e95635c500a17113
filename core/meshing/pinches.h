#pragma once
// Where a body touches itself in a point or an edge only, its surface is no manifold and its mechanics no solid's.

#include <cstddef>

#include "geometry/tetrahedra.h"

namespace glisson::meshing {

// Takes away the fewest cells found that leave one part whose surface is a watertight manifold: at each pinch, all
// but the largest group of cells that hang together by faces there, and at the end all but the largest part. Returns
// how many cells went.
std::size_t remove_pinches(geometry::TetMesh& mesh);

}  // namespace glisson::meshing
