#pragma once
// How far an atlas or a single stiffness misplaces what a surgeon looks for, over a cohort (dissertation, section 4.4).
// Between patients, a retracted liver as measured is held against the atlas (figures 4.8, 4.10 and 4.12). Within a
// liver, beams of its softest, stiffest and most uneven tissue are held against a beam of its mean (figures 4.9, 4.13
// and 4.14). The rules by which real livers are judged stand in docs/validation.md.

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

// The voxels of the dissertation's maps: what is less is imperceptible (figure 4.10).
inline constexpr double imperceptible_mm = 1.65;

struct LandmarksOptions {
  RetractionOptions retraction;
  BeamOptions beams{.engine = mechanics::Engine::fem};
  BatchPart part;       // one job of many: of a part rows are made, and nothing that sums them up
  std::string warning;  // shown on the report and in every picture; "SIMULATED ..." for a simulated cohort
  int pictures = 4;     // of typical and of extreme patients, in the report
  // The folder holds label maps of real livers, whose stiffness is drawn with this seed (real_livers.h).
  std::optional<unsigned> livers_seed;
};

// A share of a number of patients, and the 95 % interval of the probability behind it (Wilson 1927, J Am Stat Assoc
// 22:209).
struct Share {
  double fraction = 0, low = 0, high = 0;
};
[[nodiscard]] Share share_of(std::size_t patients, std::size_t of_all);

// One column of the rows: a distance, in mm.
struct LandmarksSpread {
  std::string column;
  std::string says;  // what is how far from what, for a legend
  elastography::RegionStatistics mm;
  Share significant;  // patients at 5 mm or more, of those who have the column
  std::vector<std::string>
      examples;  // the median patient, and those nearest to 1, 2, ... sd above the mean (fig. 4.12)
};

struct LandmarksSummary {
  std::vector<BatchRow> rows;
  std::size_t patients = 0, failed = 0, reused = 0;
  std::vector<LandmarksSpread> between;  // fig. 4.10
  std::vector<LandmarksSpread> within;   // fig. 4.13
  std::vector<LandmarksSpread> groups;   // of landmarks, as measured against the atlas; empty where none are known
  // What moves landmarks, on average over a patient's: stiffness, texture, supports, shape.
  std::vector<LandmarksSpread> sensitivity;
  // The meshfree engine beside finite elements, where it was asked for.
  std::vector<LandmarksSpread> engines;
  std::size_t without_meshfree = 0;  // patients for whom it found no equilibrium by the law that answers
  std::size_t at_large_strain = 0;   // patients whom neo-Hookean bodies answer for
  std::size_t beyond_linear = 0;     // strained beyond linear elasticity, and no other answer found
  double any_region_fraction = 0;    // of the patients, in whom one of the three beams at least is 5 mm off
  double slowest_s = 0;              // a patient took at most
};

// Patients as run_cohort takes them, or real livers. Into `out`: patients/ID.json, landmarks.csv, summary.json,
// report.html, and examples/ID with pictures, and {measured,atlas} (results that can be opened).
//
// Fails as run_batch and find_livers do, and with "landmarks-all-failed".
Result<LandmarksSummary> run_landmarks(const std::filesystem::path& folder, const std::filesystem::path& out,
                                       const LandmarksOptions& options = {}, const Progress& progress = {});

// The beams of one patient, in the tissue that the map is to be trusted in, against one of the liver's mean (column
// "mean_kPa"). Fails as compare_beams does.
Result<BeamRow> beams_of(const std::string& patient, const MeasuredLiver& liver, double mean_shear_kPa,
                         const LandmarksOptions& options);

// What summary.json holds, as JSON text.
Json summary_json(const LandmarksSummary& summary);

}  // namespace glisson::studies
