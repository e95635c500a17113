#pragma once
// Thin vessels for pictures: a vessel of a voxel or two has no smooth surface, marching cubes makes splinters of it.
// What is thin is drawn as tubes of its own radius around its centre line, what is thick keeps its surface.
//
// For the eye alone: tubes and surface overlap where they meet, and enclose no volume together.

#include <optional>

#include "geometry/surface.h"
#include "imaging/image.h"
#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

struct TubeOptions {
  double thin_mm = 1.5;  // tubes where the radius is smaller
  int sides = 10;        // of a tube's ring
};

// 1.5 voxels, by the voxel's volume: with less across a radius, stairs are as large as the vessel.
[[nodiscard]] double thin_radius_mm(const Eigen::Vector3d& spacing_mm);

// `outline` and `graph` are of the mask (mm, LPS). Triangles that a thin stretch is nearest to, by wall, are left
// out, and each stretch is one closed tube. Gaps and contacts of the graph get none: no vessel was outlined there.
// Nothing where no stretch is thin.
[[nodiscard]] std::optional<geometry::Surface> with_tubes(const imaging::Mask& mask, const geometry::Surface& outline,
                                                          const VesselGraph& graph, const TubeOptions& options);

}  // namespace glisson::vasculature
