#pragma once
// Surfaces from files, with turned, doubled and touching triangles mended, and what was done told.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "command.h"
#include "geometry/mend.h"

namespace glisson::cli {

struct MendedFile {
  geometry::Surface given;
  geometry::Mended mended;
  std::vector<std::string> notes;  // what was done, with the file's name; empty where nothing was
};

// Failures: those of read_surface and mended, with the file.
Result<MendedFile> read_mended(const std::filesystem::path& file, geometry::Pieces pieces = geometry::Pieces::one);

// What was done to it, among the answer's notes and in its text.
void tell_mending(const MendedFile& file, Outcome& outcome);

}  // namespace glisson::cli
