#pragma once
// Object File Format (OFF), shape alone: what the research sets of matched shapes come in.

#include <filesystem>

#include "base/result.h"
#include "geometry/surface.h"

namespace glisson::geometry {

// Polygons are cut into a fan of triangles; colours are left out. Points keep their order.
// Failures: file-not-readable, file-too-large, mesh-file-invalid (which line).
Result<Surface> read_off(const std::filesystem::path& file);

}  // namespace glisson::geometry
