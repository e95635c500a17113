#pragma once
// How far an atlas or a single stiffness misplaces what a surgeon looks for, over a cohort (dissertation, section 4.4):
// between patients, a retracted liver as measured against the atlas (figures 4.8, 4.10 and 4.12); within a liver, beams
// of its softest, stiffest and most uneven tissue against a beam of its mean (figures 4.9, 4.13 and 4.14).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "elastography/region_statistics.h"
#include "studies/dissertation/batch.h"
#include "studies/dissertation/beam_regions.h"
#include "studies/dissertation/liver_retraction.h"

namespace glisson::studies {

struct LandmarksOptions {
  RetractionOptions retraction;
  BeamOptions beams{.engine = mechanics::Engine::fem};
  std::optional<std::string> only;  // this patient alone, one job of many: its row is made, and nothing that sums up
  std::string warning;              // shown on the report and in every picture; "SIMULATED ..." for a simulated cohort
  int pictures = 4;                 // of typical and of extreme patients, in the report
};

// One column of the rows: a distance, in mm.
struct LandmarksSpread {
  std::string column;
  std::string says;  // what is how far from what, for a legend
  elastography::RegionStatistics mm;
  double significant_fraction = 0;  // of the patients, at 5 mm or more
};

struct LandmarksSummary {
  std::vector<BatchRow> rows;
  std::size_t patients = 0, failed = 0, reused = 0;
  std::vector<LandmarksSpread> between;  // fig. 4.10
  std::vector<LandmarksSpread> within;   // fig. 4.13
  double any_region_fraction = 0;        // of the patients, in whom one of the three beams at least is 5 mm off
  double slowest_s = 0;                  // a patient took at most
};

// Patients as run_cohort takes them. Into `out`: patients/ID.json, landmarks.csv, summary.json, report.html, and
// examples/ID with pictures, and {measured,atlas} (results that can be opened).
//
// Fails as run_batch does, and with "landmarks-all-failed".
Result<LandmarksSummary> run_landmarks(const std::filesystem::path& folder, const std::filesystem::path& out,
                                       const LandmarksOptions& options = {}, const Progress& progress = {});

// The beams of one patient, in the tissue that the map is to be trusted in, against one of the liver's mean (column
// "mean_kPa"). Fails as compare_beams does.
Result<BeamRow> beams_of(const std::string& patient, const MeasuredLiver& liver, double mean_shear_kPa,
                         const LandmarksOptions& options);

// What summary.json holds, as JSON text.
Json summary_json(const LandmarksSummary& summary);

}  // namespace glisson::studies
