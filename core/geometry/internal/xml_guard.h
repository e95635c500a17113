#pragma once
// What is asked of the elements of a VTK XML file before VTK's readers may open it.

#include <filesystem>

#include "base/result.h"

namespace glisson::geometry {

// Refuses what VTK 9.1's readers write beyond their memory for (found by tests/fuzz). These are counts that are no
// whole numbers, two arrays of one name in one section, and elements of more than 4096 characters. Refuses compressed
// arrays whose blocks have no size, or more bytes than a file of this size can hold. Failures: file-not-readable,
// mesh-file-invalid.
Result<void> check_xml_elements(const std::filesystem::path& file);

}  // namespace glisson::geometry
