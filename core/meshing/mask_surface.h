#pragma once
// A smooth closed surface around the voxels of a mask, for pictures: vessels, tumours, the organ.

#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::meshing {

struct MaskSurfaceOptions {
  // Iterations and pass band of the windowed-sinc smoothing (Taubin, Zhang and Golub 1996). It takes the voxels' stairs
  // away and hardly shrinks what is thicker than a few voxels. These keep vessels of two voxels.
  int smoothing_iterations = 20;
  double pass_band = 0.1;
};

// For organs, where nothing is thin: what 3D Slicer does to its segments at its default smoothing factor of 0.5.
inline constexpr MaskSurfaceOptions organ_smoothing{40, 0.01};

// In patient coordinates (LPS, mm), triangles counter-clockwise from outside; a structure that touches the image's
// border is closed there. Fails with "mask-empty".
Result<geometry::Surface> mask_surface(const imaging::Mask& mask, const MaskSurfaceOptions& options = {});

}  // namespace glisson::meshing
