#pragma once
// From a sampled distance to the closed surface where it is zero.

#include <functional>

#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::anatomy {

using Field = imaging::Image<float>;  // mm outside the shape, negative inside

// An axis-parallel grid over the box.
[[nodiscard]] imaging::Grid grid_over(const geometry::Box& box, double spacing_mm);

// The function at every voxel's centre, on all threads. Blocks that lie farther than `far_mm` from the surface hold
// about that, with the right sign: `distance_mm` must not overestimate by more than half there.
[[nodiscard]] Field sampled(const imaging::Grid& grid,
                            const std::function<double(const Eigen::Vector3d&)>& distance_mm);

// Between the voxels' centres, trilinear; what lies beside the grid takes the value at its border.
[[nodiscard]] double interpolated(const Field& field, const Eigen::Vector3d& position_mm);

// Surface nets (Gibson 1998, Constrained elastic surface nets): one point in each cell that the surface crosses, the
// mean of the crossings of its edges. Corners that would make the surface touch itself are taken in first, so
// that it is a manifold. Closed: the outermost voxels count as outside. Triangles counter-clockwise from outside.
[[nodiscard]] geometry::Surface level_surface(Field field);

}  // namespace glisson::anatomy
