#pragma once
// Surfaces that hang together, for what walks along them.

#include "geometry/surface.h"

namespace glisson::geometry {

// The largest piece (by area) of what hangs together by shared edges. Points where only corners meet are made two. A
// triangle that would be an edge's third is left out. What comes back has no edge of more than two triangles and one
// fan of triangles around each point, which geodesics need. Its points keep their order and their fields.
[[nodiscard]] Surface largest_manifold_piece(const Surface& surface);

}  // namespace glisson::geometry
