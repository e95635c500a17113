#pragma once
// Measured strain and stress for the data-driven solver, out of a plain table or a material experiment.

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "mechanics/materials/material_data.h"

namespace glisson::closedloop {

// Reads a CSV with the columns "strain" and "stress_kPa" (nominal, compression negative). Reads also an experiment of
// kind "material" under compression or tension (JSON), all its trials together. Failures: those of reading either;
// "experiment-not-material"; "data-invalid" (shear, which says nothing about stretching).
Result<std::vector<mechanics::StressStrain>> read_stress_strain(const std::filesystem::path& file);

}  // namespace glisson::closedloop
