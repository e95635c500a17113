#pragma once
// Where a surface crosses the cells of a body: each cell's part above it and its share of the wall. Inside of this
// room.

#include <array>
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "geometry/cut_surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

// A tetrahedron divided by the plane that takes the surface's heights at its corners.
struct CellDivision {
  double share_above = 0;                      // of its volume, between 0 and 1
  Eigen::Vector4d centroid_above{0, 0, 0, 0};  // barycentric
  Eigen::Vector4d centroid_below{0, 0, 0, 0};
  std::vector<Eigen::Vector4d> wall;  // three or four places in order around it, barycentric
};
// Heights (mm) none of which is zero, and not all of one sign.
[[nodiscard]] CellDivision divide(const Eigen::Vector4d& height_mm);

// The same as tetrahedra, each by the barycentric coordinates of its corners, one a column. The determinant is its
// share of the cell's volume, but for the sign.
struct CellPiece {
  Eigen::Matrix4d corners;
  bool above;
};
[[nodiscard]] std::vector<CellPiece> pieces_of(const Eigen::Vector4d& height_mm);

struct CrossedCell {
  int cell;
  CellDivision division;
  double wall_area_mm2;
  Eigen::Vector4d wall_centroid;  // barycentric
  Eigen::Vector3d wall_normal;    // unit, to above
};

// A body as a surface crosses it.
struct Crossing {
  std::vector<double> height_mm;  // of each point of the mesh, never zero
  std::vector<CrossedCell> cells;
  std::vector<std::vector<int>> cells_of_point;  // of each point of the mesh, as numbers in `cells`
};

// A point nearer to the surface than a hundredth of the mean edge is taken to lie that far above it. So what is cut off
// of a cell is never much thinner.
[[nodiscard]] std::vector<double> heights_mm(const geometry::TetMesh& mesh, const geometry::CutSurface& surface);

// Where these heights change sign. Of a swept line the cells near it alone: all around the points of those that it
// parts, for which twice the longest edge suffices.
[[nodiscard]] Crossing crossing_of(const geometry::TetMesh& mesh, const geometry::CutSurface& surface,
                                   std::vector<double> height_mm);

// Places spread evenly over a cell's wall: barycentric, with the area (mm2) that each stands for.
[[nodiscard]] std::vector<std::pair<Eigen::Vector4d, double>> places_on_wall(
    const CrossedCell& crossed, const Eigen::Matrix<double, 3, 4>& corner_mm);

}  // namespace glisson::mechanics
