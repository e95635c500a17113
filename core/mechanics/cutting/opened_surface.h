#pragma once
// The surface of a body whose cut has opened, to be drawn: its triangles divided at the cut, and both walls of it.

#include <Eigen/Core>
#include <vector>

#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/cutting/opening.h"

namespace glisson::mechanics {

// `boundary` is the mesh's (geometry::boundary_surface), `displacement_mm` of each of its points, `jumps_mm` of
// Opening::points(). Points are displaced, patient LPS, mm: first the boundary's, then those along the cut. The cell
// field "wall" is 1 on the cut's walls and 0 elsewhere; the point field "at_rest_mm" is where they are at rest. Where
// the front has not passed, walls lie in each other.
[[nodiscard]] geometry::Surface opened_surface(const geometry::TetMesh& mesh, const geometry::Surface& boundary,
                                               const std::vector<OpenCell>& open,
                                               const std::vector<Eigen::Vector3d>& displacement_mm,
                                               const std::vector<Eigen::Vector3d>& jumps_mm);

}  // namespace glisson::mechanics
