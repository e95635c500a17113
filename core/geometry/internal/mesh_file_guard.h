#pragma once
// What is asked of a mesh file before a library that trusts its header may open it.

#include <filesystem>

#include "base/result.h"

namespace glisson::geometry {

// Refuses a VTK, PLY or STL file whose header announces more points, cells or values than a file of this size can hold.
// Failures: file-not-readable, mesh-too-large.
Result<void> check_announced_counts(const std::filesystem::path& file);

}  // namespace glisson::geometry
