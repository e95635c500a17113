#pragma once
// Whether a simulation on MRE stiffness places a surface where a scanner sees it. A phantom is pressed, and the
// simulated surface is held against the scanned one (dissertation, section 4.5).
//
// The phantom is table 4.2's cylinder, 225 mm across and 26 mm high, on its chassis, which is taken to be rigid.
// Phantom A is soft, B stiff, and A/B has a soft stratum of half the height on a stiff one. The moduli are those that
// section 4.6 measured by MRE. The tool's size is not reported. Linear elasticity: at the larger loads an
// extrapolation, and the largest strain says how far.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/tissue.h"
#include "geometry/surface.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

struct PalpationTrial {
  std::string phantom;     // "A", "B" or "AB"
  double force_N = 0;      // downwards, in the middle
  double reported_mm = 0;  // the error of table 4.4

  [[nodiscard]] std::string name() const;  // "A-1.69N"
};
// The nine of table 4.4. Their errors average 2.25 mm, while the text of section 4.5 says 2.14 mm.
[[nodiscard]] const std::vector<PalpationTrial>& dissertation_trials();
constexpr double reported_mean_in_text_mm = 2.14;

struct PalpationOptions {
  double soft_kPa = 17.47, stiff_kPa = 36.81;  // Young's moduli by MRE
  double poisson_ratio = usual_poisson_ratio;
  double tool_radius_mm = 20;  // our assumption

  // Scanned surfaces, PLY or any format of geometry/mesh_file.h, in mm: A-rest.ply, A-1.69N.ply, and so on, for the
  // trials there are. Each phantom's scan at rest is aligned with the model by ICP from where it lies, and its other
  // scans move with it. Without them scans are SIMULATED. They are of the same phantom with the moduli that section
  // 4.6's testing machine found. They see it from one side, with the tool in the way and 0.1 mm of noise, and begin
  // from a rough placement.
  std::optional<std::filesystem::path> scans;
};

struct PalpationSummary {
  std::vector<BatchRow> rows;   // mean_mm, rms_mm, max_mm, near_tool_mm, depth_mm, largest_strain, alignment_mm
  double mean_mm = 0;           // of the rows' means
  double reported_mean_mm = 0;  // of the same trials in table 4.4
  double worst_mm = 0;
  bool simulated_scans = true;
};

// Into `out`: patients/TRIAL.json, palpation.csv, summary.json, report.html. Can be stopped and taken up again.
// Fails as run_batch does, and with "palpation-no-scans", "palpation-all-failed".
Result<PalpationSummary> run_palpation(const std::filesystem::path& out, const PalpationOptions& options = {},
                                       const Progress& progress = {});

// The phantom at rest and pressed, one surface each with the same points; for tests and pictures.
struct PressedPhantom {
  geometry::Surface rest, pressed;
  double depth_mm = 0;        // the middle of the top, downwards
  double largest_strain = 0;  // in magnitude
};
Result<PressedPhantom> press(const std::string& phantom, double force_N, double soft_kPa, double stiff_kPa,
                             const PalpationOptions& options);

}  // namespace glisson::studies
