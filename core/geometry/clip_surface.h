#pragma once
// The piece of a surface that lies on one side of a cut.

#include "geometry/cut_surface.h"
#include "geometry/surface.h"

namespace glisson::geometry {

enum class CutSide { above, below };  // of the cut, along its normal

// Triangles that the cut crosses are divided along it, their edges where the height over it, taken as linear along the
// edge, is zero: exact for a plane. The piece is open along the cut. Fields are left behind.
[[nodiscard]] Surface clipped(const Surface& surface, const CutSurface& cut, CutSide side);

}  // namespace glisson::geometry
