#pragma once
// Where given points lie in a body of tetrahedra.

#include <Eigen/Core>
#include <vector>

#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

// A place in a cell. A point outside the body is taken to the nearest place on its boundary, at `outside_by_mm`.
struct PointInMesh {
  int cell = -1;
  Eigen::Vector4d barycentric{0, 0, 0, 0};  // of the cell's corners; not negative (to rounding), sums to 1
  double outside_by_mm = 0;                 // 0 inside
};

// One place for each position (patient LPS, mm, finite). The mesh must have passed check_tetrahedra.
[[nodiscard]] std::vector<PointInMesh> locate_points(const geometry::TetMesh& mesh,
                                                     const std::vector<Eigen::Vector3d>& positions_mm);

// How many cells have their centroid in another one: none, but of a body that folds over itself where its cells share
// no face. Takes n log n for n cells. The mesh must have passed check_tetrahedra.
[[nodiscard]] int cells_in_others(const geometry::TetMesh& mesh);

}  // namespace glisson::mechanics
