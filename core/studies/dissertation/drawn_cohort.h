#pragma once
// A SIMULATED cohort drawn from a shape model of real livers: meshed, each with a stiffness by section 4.3's figures.

#include <cstdint>
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

struct DrawnCohortOptions {
  int count = 10;
  std::uint64_t seed = 1;
  int target_cells = 20000;
  enum class Vessels { carried, none } vessels = Vessels::carried;  // by the shape's warp (shapes/carried_vessels.h)
  double reference_spacing_mm = 7;                                  // that the model was made with (ShapesOptions)
};

struct DrawnCohort {
  std::vector<BatchRow> rows;
  std::size_t livers = 0, failed = 0, reused = 0;
  double mean_volume_ml = 0, sd_volume_ml = 0;
  double cpu_seconds_a_liver = 0;  // of those made now, on one thread each
};

// Into `out`: simulated-00001.vtu and so on, with the cell fields "region" and "youngs_modulus_kPa";
// simulated-00001_trees.json, its vessels as a case keeps them; patients/ID.json, livers.csv, and SIMULATED.txt, which
// says what they are. A liver depends on the model, the seed and its number alone. Failures: those of read_model,
// reference_vessels and run_batch; "vessels-not-corresponding" (the model was made of another reference).
Result<DrawnCohort> draw_cohort(const std::filesystem::path& model, const std::filesystem::path& out,
                                const DrawnCohortOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::studies
