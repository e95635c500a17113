#pragma once
// A body of tetrahedra in patient coordinates (LPS, mm), with quantities on its points and cells.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/field.h"
#include "geometry/surface.h"

namespace glisson::geometry {

struct TetMesh {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::array<int, 4>> cells;  // positive volume: (p1-p0) x (p2-p0) . (p3-p0) > 0
  Fields point_fields;
  Fields cell_fields;  // "region": the label each cell belongs to, where it came from labels
};

[[nodiscard]] double cell_volume_mm3(const TetMesh& mesh, std::size_t cell);
[[nodiscard]] double volume_mm3(const TetMesh& mesh);
[[nodiscard]] Eigen::Vector3d cell_centroid_mm(const TetMesh& mesh, std::size_t cell);

// The outer surface, its triangles counter-clockwise from outside. Points are renumbered; the point field
// "mesh_point" tells which point of the mesh each one is, the cell field "mesh_cell" the tetrahedron behind each
// triangle.
[[nodiscard]] Surface boundary_surface(const TetMesh& mesh);

// Which part each cell belongs to, parts being cells that hang together by faces: 0 is the part of the most cells.
[[nodiscard]] std::vector<int> parts_by_faces(const TetMesh& mesh);

// The cells named, in that order, with the points that they use and all fields.
[[nodiscard]] TetMesh part_of(const TetMesh& mesh, const std::vector<int>& cells);

struct TetQuality {
  double min_dihedral_deg = 0;
  double max_dihedral_deg = 0;
  double mean_aspect = 0;  // longest edge over the shortest height, scaled to 1 for the regular tetrahedron
  double max_aspect = 0;
};
[[nodiscard]] TetQuality quality(const TetMesh& mesh);

// Refuses what no later stage can use: an index out of range, a point that is not finite, or no cells. Refuses a cell
// of zero or negative volume, and names the first. Refuses parts that do not hang together by faces, and names their
// number and sizes.
Result<void> check_tetrahedra(const TetMesh& mesh);

// The same, but that parts may hang apart: a body that was cut.
Result<void> check_cells(const TetMesh& mesh);

}  // namespace glisson::geometry
