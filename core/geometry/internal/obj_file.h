#pragma once
// Wavefront OBJ, shape alone. Ours rather than VTK's, which renumbers the points of a file with texture coordinates:
// vertex i must stay vertex i where surfaces are matched.

#include <filesystem>

#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::geometry {

// Polygons are cut into a fan of triangles. Normals, texture coordinates, groups and materials are left out.
// Failures: file-not-readable, file-too-large, mesh-file-invalid (which line).
Result<Surface> read_obj(const std::filesystem::path& file);
Result<void> write_obj(const std::filesystem::path& file, const Surface& surface);

}  // namespace glisson::geometry
