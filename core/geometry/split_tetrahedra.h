#pragma once
// Tetrahedra divided by a surface: the volumes on its two sides, and a mesh whose faces lie on it, opened or not.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/cut_surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::geometry {

// The volume on each side (mm3). Exact for a plane. For a sheet each cell that it may cross is divided into 8^levels,
// with the sheet taken as flat in each. `error_mm3` is how much the last division changed. The error that is left is
// about a third of it, and falls to a quarter with each level.
struct DividedVolume {
  double above_mm3 = 0;
  double below_mm3 = 0;
  double error_mm3 = 0;
};
[[nodiscard]] DividedVolume divided_volume(const TetMesh& mesh, const CutSurface& cut, int levels = 3);

// The same of a body that is deformed. A cell is divided where it now lies, and counts with its given volume at rest
// (mm3, one a cell). Exact for a plane, since within a cell the deformation is affine and keeps shares.
[[nodiscard]] DividedVolume divided_volume(const TetMesh& mesh, const CutSurface& cut,
                                           const std::vector<double>& cell_volumes_mm3, int levels = 3);

struct SplitOptions {
  // Where the surface crosses an edge, a point of the mesh may be nearer to it than this share of the edge. It is then
  // taken to lie on the surface. The cut then passes through the point, and no sliver is left.
  double snap = 0.15;
  // Whether the cut is open at a place; nothing: everywhere. Where it is closed the body still hangs together.
  std::function<bool(const Eigen::Vector3d&)> is_open;
};

struct SplitMesh {
  TetMesh mesh;
  std::vector<int> parent;        // of each cell, the cell that it is a piece of
  std::vector<std::int8_t> side;  // of each cell: 1 above, -1 below
  // Points of the cut that were doubled: as seen from below, and from above.
  std::vector<std::array<int, 2>> doubled;
  Surface cut;  // the faces that lie on the surface, counter-clockwise seen from above; point field "mesh_point"
  double largest_shift_mm = 0;  // how far the surface lies from a point that was taken to lie on it
};

// Each cell that the surface crosses is divided along it, neighbours alike. The pieces of a convex cell are cones over
// the faces that do not hold its point of the smallest number. Fields of points are interpolated. One that holds only 0
// and 1 names points: there a new point has a name only where both ends of its edge have it. Fields of cells are the
// parent's. The cell field "cut_side" (1, -1) and the point field "on_cut" (0, 1) are added, or where present replaced
// and joined. The mesh must have passed check_tetrahedra. A surface that crosses nothing leaves the mesh.
[[nodiscard]] SplitMesh split_tetrahedra(const TetMesh& mesh, const CutSurface& cut, const SplitOptions& options = {});

}  // namespace glisson::geometry
