#pragma once
// Parts of a surface: what lies on one side of a cut, and what is kept of its triangles.

#include <functional>

#include "geometry/cut_surface.h"
#include "geometry/surface.h"

namespace glisson::geometry {

enum class CutSide { above, below };  // of the cut, along its normal

// Triangles that the cut crosses are divided along it. Their edges are divided where the height over it, taken as
// linear along the edge, is zero: exact for a plane. The piece is open along the cut. Fields are left behind.
[[nodiscard]] Surface clipped(const Surface& surface, const CutSurface& cut, CutSide side);

// The triangles that are kept, asked for by their number, with the points that they use. Fields are left behind.
[[nodiscard]] Surface kept_part(const Surface& surface, const std::function<bool(std::size_t triangle)>& is_kept);

}  // namespace glisson::geometry
