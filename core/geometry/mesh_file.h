#pragma once
// Surfaces and tetrahedra in files. Lengths in files are mm, in patient coordinates (LPS), as in memory.
//
// Files come from anywhere and are not trusted. What a header announces is held against the file's size before memory
// is asked for. Every index is held against the points there are. Writing is all or nothing (write_atomically).
//
// Failures: file-not-readable, mesh-format-unknown (by the name's extension), mesh-file-invalid (what the reader
// found), mesh-cell-type, mesh-too-large, and those of check_surface.

#include <filesystem>

#include "base/result.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::geometry {

// Reads .vtp, .vtk (polygons), .stl, .obj, .off or .ply. Points keep their order, but the points which STL repeats for
// every triangle are merged. Polygons are cut into triangles. Lines and loose vertices are left out. All numeric point
// and cell arrays of the VTK formats become fields.
Result<Surface> read_surface(const std::filesystem::path& file);

// Writes .vtp (with all fields, in double precision), or .stl, .obj or .ply (shape alone; STL and PLY in single
// precision).
Result<void> write_surface(const std::filesystem::path& file, const Surface& surface);

// Reads .vtu or .vtk. Quadratic tetrahedra are read as the tetrahedra of their corners. Cells are turned to positive
// volume; points that no tetrahedron uses are left out; any other type of cell is refused by its name. A flat cell
// or a mesh in parts is not refused here: see check_tetrahedra.
Result<TetMesh> read_tetrahedra(const std::filesystem::path& file);

// Writes .vtu, with all fields, in double precision.
Result<void> write_tetrahedra(const std::filesystem::path& file, const TetMesh& mesh);

}  // namespace glisson::geometry
