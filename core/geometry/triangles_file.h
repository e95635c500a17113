#pragma once
// A plane of triangles in a file.

#include <filesystem>

#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::geometry {

// What read_surface (mesh_file.h) reads, and .vtu: its triangles, quadratic ones by their corners, and quadrangles in
// two, with all point arrays. Edges and vertices are left out, any other type of cell is refused by its name.
Result<Surface> read_triangles(const std::filesystem::path& file);

}  // namespace glisson::geometry
