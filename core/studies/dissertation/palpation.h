#pragma once
// Whether a model on MRE stiffness lies where a pressed phantom lies (dissertation, section 4.5, tables 4.2 to 4.4).
//
// The phantom is table 4.2's cylinder, 225 mm across and 26 mm high, on its chassis, which is taken to be rigid.
// Phantom A is soft, B stiff, and A/B has a soft stratum of half the height on a stiff one. A+b and B+a, which the
// dissertation does not have, hold a ball of the other compound. A rigid ball presses on the middle. The tool's size is
// not reported.
//
// No phantom was measured here. The truth is SIMULATED by a solver of its own on a mesh of its own
// (internal/revolved_press.h, which CalculiX judges in a test), of the moduli that section 4.6's testing machine found.
// The model knows none of them. Its moduli come from simulated phase images of waves in closed form, with noise,
// through the program's inversion. Its ball is the program's own at large strain, its law neo-Hookean. So the study can
// fail. Three faults on purpose show that: moduli that are 1.5 times those found, a gel that stiffens, and one that is
// nearly incompressible.
//
// Plan, limit and seed were fixed before any outcome was looked at.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/tissue.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

// What is wrong on purpose.
enum class PalpationFault {
  none,
  modulus,  // the model has 1.5 times the moduli that were found for it
  law,      // the gel stiffens: its energy of shape is G/2 ((I - 3) + (I - 3)^2)
  poisson,  // the gel's Poisson's ratio is 0.49, its shear modulus the same, and nobody tells the model
};

struct PalpationTrial {
  std::string phantom;                // "A", "B", "AB", "A+b" or "B+a"
  double force_N = 0;                 // downwards, in the middle
  std::optional<double> reported_mm;  // the error of table 4.4, where it has one
  PalpationFault fault = PalpationFault::none;

  [[nodiscard]] std::string name() const;  // "A-1.69N", "A-7.81N-law"
};
// The nine of table 4.4. Their errors average 2.25 mm, while the text of section 4.5 says 2.14 mm.
[[nodiscard]] const std::vector<PalpationTrial>& dissertation_trials();
constexpr double reported_mean_in_text_mm = 2.14;
// Those, the phantoms with a ball in them at the same forces as their hosts, and the faults on A at 7.81 N.
[[nodiscard]] const std::vector<PalpationTrial>& palpation_plan();

// A trial holds where the ball lies as deep as in truth to within this share of the depth. By Hertz's law the depth
// goes with the modulus to the power of -2/3, so that a modulus 15 % off is 10 % of depth.
constexpr double palpation_limit = 0.10;
// Of the section's text: half a centimetre is what matters to a surgeon.
constexpr double clinical_limit_mm = 5;

struct PalpationOptions {
  double poisson_ratio = usual_poisson_ratio;  // the model's
  double ball_radius_mm = 20;                  // our assumption

  // Young's moduli that the model takes for the compounds, in place of what the simulated scan finds; with scans, in
  // place of what section 4.6 found by MRE.
  std::optional<double> soft_kPa, stiff_kPa;

  std::vector<std::string> only;            // names of trials; empty: all
  int bricks_across = 12, bricks_high = 4;  // of the model's mesh, six tetrahedra each; even

  // Scanned surfaces, PLY or any format of geometry/mesh_file.h, in mm: A-rest.ply, A-1.69N.ply, and so on, for the
  // trials there are. Each phantom's scan at rest is aligned with the model by ICP from where it lies, and its other
  // scans move with it. How deep the tool went is not known then, and nothing is judged.
  std::optional<std::filesystem::path> scans;
};

struct PalpationSummary {
  // force_N, reported_mm, depth_mm, largest_strain, mean_mm, rms_mm, max_mm, near_tool_mm, alignment_mm. With simulated
  // truth also true_depth_mm, off_percent (of the depth), told_off_percent (the same with the true moduli, at the
  // largest force of each phantom), soft_kPa
  // and stiff_kPa (means over the cells of the compound), measured_percent (of the cells) and contact_radius_mm.
  std::vector<BatchRow> rows;
  std::vector<PalpationTrial> trials;  // of the rows
  double mean_mm = 0;                  // of the surface's error, over the trials of table 4.4
  double reported_mean_mm = 0;         // of the same trials there
  double worst_mm = 0;
  bool simulated_scans = true;

  // Of simulated truth alone.
  int honest = 0, held = 0;              // trials without a fault, and those within the limit
  int faults = 0, caught = 0;            // trials with one, and those beyond it
  int faults_within_clinical_limit = 0;  // whose surface error, on average, would not have shown them
  bool moduli_and_law_are_told = true;   // no trial with a wrong modulus or law was within the limit
  [[nodiscard]] bool passed() const { return !simulated_scans || (held == honest && moduli_and_law_are_told); }
};

// Into `out`: patients/TRIAL.json, palpation.csv, summary.json, report.html. Can be stopped and taken up again.
// Fails as run_batch does, and with "palpation-no-scans", "palpation-no-trial", "palpation-all-failed".
Result<PalpationSummary> run_palpation(const std::filesystem::path& out, const PalpationOptions& options = {},
                                       const Progress& progress = {});

}  // namespace glisson::studies
