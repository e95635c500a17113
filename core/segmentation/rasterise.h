#pragma once
// From a closed surface to the voxels inside it.

#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// The voxels of `grid` whose centre lies inside the surface. Both are in the same frame (patient LPS, mm), and the grid
// may be rotated and anisotropic. `closed` must have passed geometry::check_surface.
//
// Every row of voxels counts how often it crosses the surface before each voxel: inside after an odd number. The
// crossings are decided in integers on points rounded to 1/1024 of a voxel. So a row through an edge or a vertex is
// crossed once. No row can leak from a closed surface, whichever way its triangles are turned. Parts that overlap
// cancel, as a surface nested in another makes a cavity: rasterise such parts by themselves. A row that does leak,
// because the surface has a hole, is decided by the rows along the two other axes. Deterministic, whatever the number
// of threads.
[[nodiscard]] imaging::Mask rasterise(const geometry::Surface& closed, const imaging::Grid& grid);

}  // namespace glisson::segmentation
