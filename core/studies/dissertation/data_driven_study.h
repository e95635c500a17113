#pragma once
// Chapter 5 and figure 5.3 of the dissertation: a liver retracted straight from measured strain and stress. Beside it
// stands the same liver by a linear law fitted to the measurements.
//
// Measurements are SIMULATED uniaxial tests of a tissue that stiffens, with noise and with outliers. Its stress over
// strain has doubled at 20 % strain. The truth is that tissue's own law on the same mesh. Or they are somebody's own;
// then there is no truth, and the two answers stand beside each other.
//
// The liver is generated (patient 1 of anatomy), on its usual supports, lifted at segment VI. Small strain throughout,
// as the solver has it (mechanics/statics/data_driven.h).

#include <filesystem>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/materials/material_data.h"

namespace glisson::studies {

struct DataDrivenStudyOptions {
  std::vector<mechanics::StressStrain> measured = {};  // empty: SIMULATED
  std::vector<int> counts{21, 100, 400};      // of simulated measurements; how many chapter 5 has is not in its text
  std::vector<double> noises{0, 0.02, 0.05};  // standard deviation of a stress, of the largest measured stress
  int outliers_one_in = 40;  // where there is noise: one measurement in so many is half the largest stress off; 0: none
  double farthest_strain = 0.35;  // of a simulated test, either way
  double force_N = 1;             // half of the retractor's usual force: within the strains that are tested
  int target_cells = 3000;
  double poisson_ratio = usual_poisson_ratio;
  std::uint64_t seed = 1;
};

// How far points of the body are from where the truth has them, over all of its points.
struct PointErrors {
  double mean_mm = 0, largest_mm = 0;
};

struct DataDrivenRow {
  int measurements = 0;
  double noise = 0;  // of the largest stress
  int outliers = 0;
  // Measurements that the line of the linear region fits. The line goes through the origin and is fitted up to 5 %
  // strain. It must come within 5 % of the largest stress and three standard deviations of the noise.
  int on_the_line = 0;
  double slope_kPa = 0;         // of the line through all measurements
  double slope_region_kPa = 0;  // of the line through those of the linear region
  double retraction_mm = 0;     // the largest displacement, from data
  int rounds = 0;
  bool converged = true;       // else the answer where the rounds ended: noise may keep states wandering
  double strained_beyond = 0;  // share of the body's volume that is strained farther than was measured
  // Against the truth where it is known; without a truth, against the answer from data.
  std::optional<PointErrors> from_data;
  PointErrors by_line;
  std::optional<PointErrors> by_region_line;  // absent where noise gives the linear region no slope above zero
  std::vector<mechanics::StressStrain> measured;
};

struct DataDrivenStudy {
  std::vector<DataDrivenRow> rows;
  bool simulated = true;
  std::optional<double> true_retraction_mm;
  std::size_t cells = 0;
};

// Failures: "study-options" (a number out of range), those of material data and of the solver,
// "not-converged" (the truth's own law).
Result<DataDrivenStudy> run_data_driven(const DataDrivenStudyOptions& options, const Progress& progress = {});

// data-driven.csv, measured.csv (of the last row), summary.json and report.html.
Result<void> write_data_driven(const std::filesystem::path& out, const DataDrivenStudy& study);

}  // namespace glisson::studies
