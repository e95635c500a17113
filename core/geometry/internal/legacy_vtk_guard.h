#pragma once
// What is asked of a legacy VTK file before VTK's own reader, which believes the cell lists, may open it.

#include <filesystem>

#include "base/result.h"

namespace glisson::geometry {

// Walks a .vtk file of dataset type POLYDATA or UNSTRUCTURED_GRID, text or binary, up to its point and cell data.
// Refuses it where a cell list contradicts itself. That is so with cells of more or fewer points than the list holds,
// with offsets that go back, or with missing parts. It is so with another number of cell types than of cells. Point
// numbers are left to the caller. Failures: file-not-readable, file-too-large, mesh-file-invalid.
Result<void> check_cell_lists(const std::filesystem::path& legacy_vtk_file);

}  // namespace glisson::geometry
