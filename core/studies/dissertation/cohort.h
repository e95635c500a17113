#pragma once
// How stiffness varies between patients and within them, over a cohort of MRE maps (dissertation, section 4.3). The
// distribution of the patients' means is held against the atlas (fig. 4.6), the spread within a patient against the
// mean (fig. 4.7). All moduli are shear moduli in kPa.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "imaging/image.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

struct CohortOptions {
  // The atlas: the published mean of healthy livers that section 4.3 compares with, and the half-width within which 95
  // % of that cohort lie. Bins of figs. 4.6 and 4.7 are as wide as that interval, about the atlas's mean.
  double reference_kPa = 2.6;
  double reference_half_width_kPa = 0.5;
  BatchPart part;       // of a part, one job of many that share the folder, rows are made and nothing that sums them up
  std::string warning;  // shown on the report; "SIMULATED ..." for a simulated cohort
};

struct CohortBin {
  double low_kPa = 0, high_kPa = 0;
  std::size_t patients = 0;
  double mean_sd_kPa = 0;  // of the patients' standard deviations; 0 where there are none
};

struct CohortSummary {
  std::vector<BatchRow> rows;
  std::size_t patients = 0, failed = 0, reused = 0;
  double mean_kPa = 0, sd_kPa = 0, median_kPa = 0;  // of the patients' means
  double low_kPa = 0, high_kPa = 0;                 // between which 95 % of them lie
  double like_reference_fraction = 0;               // within the atlas's half-width of this cohort's own median
  double in_reference_fraction = 0;                 // within it of the atlas's mean
  double upper_limit_ratio = 0;                     // high_kPa over the atlas's upper limit
  double rank_correlation = 0;                      // Spearman's, of sd with mean; 1: always grows
  std::vector<CohortBin> bins;
};

// Patients are the stiffness maps under a folder and the cases in it. The maps are files that imaging::scan gives that
// role; all positive voxels count. A case (NAME.glisson) has volumes/stiffness, which counts inside labels/liver where
// there is one. Into `out`: patients/ID.json or chunks/K-of-N.json, cohort.csv, summary.json, report.html.
//
// Fails as run_batch does, and with "cohort-all-failed".
Result<CohortSummary> run_cohort(const std::filesystem::path& folder, const std::filesystem::path& out,
                                 const CohortOptions& options = {}, const Progress& progress = {});

// The patients' names, as run_cohort takes them. Fails where the folder cannot be read.
Result<std::vector<std::string>> cohort_patients(const std::filesystem::path& folder);

// What summary.json holds, as JSON text.
Json summary_json(const CohortSummary& summary);

// Writes a SIMULATED cohort of liver maps as NRRD into the folder, slices 10 mm apart. Each has a generated liver
// (anatomy/patient.h); by seed 1 they are the generator's seeds from 1 on. Stiffness is drawn so that 64 % of the
// patients lie within 0.5 kPa of 2.1 kPa. The upper 95 % limit is 4.8 times the atlas's. The spread within a liver
// grows from 0.95 kPa in proportion to the mean. The shares, the limit and the spread are section 4.3's. Its 64 %
// however lie about the atlas's mean, 2.6 kPa, while its cohort's mean is 2.1. Here the typical patient has 2.1. The
// same seed gives the same cohort.
Result<void> write_simulated_cohort(const std::filesystem::path& folder, int patients, unsigned seed = 1);

// One such SIMULATED map of shear stiffness within a liver of any shape: mean and spread drawn as above.
imaging::Volume simulated_liver_map(const geometry::Surface& liver, unsigned seed);

// What every report on the folder's patients must say: the text of SIMULATED.txt in it, which write_simulated_cohort
// leaves there; empty without one.
[[nodiscard]] std::string cohort_warning(const std::filesystem::path& folder);

}  // namespace glisson::studies
