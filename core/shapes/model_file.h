#pragma once
// A shape model in a file that ParaView and 3D Slicer open. It is the mean as .vtp, with each mode as displacements of
// its points by one standard deviation.

#include <filesystem>

#include "base/result.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

// Point arrays mode_001_mm, mode_002_mm, ..., residual_sd_mm, and livers: that it was made from, the same everywhere.
Result<void> write_model(const std::filesystem::path& file, const ShapeModel& model);

// Failures: those of read_surface; "shapes-not-a-model" (an array is missing, or holds what is no number).
Result<ShapeModel> read_model(const std::filesystem::path& file);

}  // namespace glisson::shapes
