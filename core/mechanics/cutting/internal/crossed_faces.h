#pragma once
// Faces of a body's boundary as a surface divides them. Inside of this room.

#include <Eigen/Core>
#include <vector>

#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/boundary.h"

namespace glisson::mechanics {

// A part of a face on one side, as a triangle by its corners in barycentric coordinates.
struct FacePart {
  Eigen::Matrix3d corners;  // one a column
  double share;             // of the face's area
  bool above;
};

// The whole face where the surface does not cross it.
[[nodiscard]] std::vector<FacePart> parts_of(const Crossing& crossing, const BoundaryFace& face);

}  // namespace glisson::mechanics
