#pragma once
// Reading Stanford PLY, shape alone. Ours rather than VTK's, which crashes on headers that are damaged.

#include <filesystem>

#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::geometry {

// Text and binary of either byte order. Polygons are cut into a fan of triangles; other elements and properties are
// passed over. Failures: file-not-readable, file-too-large, mesh-too-large, mesh-file-invalid (what is wrong).
Result<Surface> read_ply(const std::filesystem::path& file);

}  // namespace glisson::geometry
