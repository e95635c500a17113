#pragma once
// The boundary of labelled voxels as it is, steps and all.

#include "geometry/surface.h"
#include "meshing/label_pieces.h"

namespace glisson::meshing {

// The faces between the body and the outside, two triangles each, outward. They are in the grid's own frame (spacing
// times voxel index, mm). A voxel reaches half a spacing to either side of its centre.
[[nodiscard]] geometry::Surface voxel_faces(const PieceMap& map);

}  // namespace glisson::meshing
