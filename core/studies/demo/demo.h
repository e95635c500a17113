#pragma once
// The main job, end to end, on the demo patient. A DICOM study is written, read back, segmented, meshed, given its own
// stiffness, and pulled aside by a retractor. The report compares it with the atlas. SIMULATED throughout.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "elastography/cell_stiffness.h"
#include "rehearsal/comparison.h"

namespace glisson::studies {

struct DemoRunOptions {
  int target_cells = 20000;
  double force_N = 0;  // of the retractor; 0: the preset's usual force
};

struct DemoSummary {
  std::filesystem::path case_folder;
  std::filesystem::path report;
  std::vector<std::filesystem::path> pictures;

  double liver_ml = 0;
  double true_liver_ml = 0;
  double liver_dice = 0;  // of the grown liver with the true one
  std::size_t cells = 0;
  double min_dihedral_deg = 0;
  double hausdorff_mm = 0;
  elastography::CellStiffness stiffness;
  double stiffness_error_kPa = 0;  // mean absolute error of the cells' Young's modulus against the truth
  std::string tool;
  double force_N = 0;
  double relative_residual = 0;
  double max_displacement_mm = 0;
  mechanics::Validity validity = {};  // of the equilibrium on the patient's own stiffness
  rehearsal::Comparison reference_against_mre;
  double seconds = 0;
};

// Into `out`: dicom/ and truth/ (see patient.h), demo.glisson/, pictures/, report.html, summary.json. What an
// earlier run left there is replaced; anything else in the folder stays. Fails with "demo-folder-taken" where `out`
// holds files that are no demo's.
Result<DemoSummary> run_demo(const std::filesystem::path& out, const DemoRunOptions& options = {},
                             const Progress& progress = {});

// The summary as JSON text, as summary.json holds it and `demo --json` prints it.
Json summary_json(const DemoSummary& summary);

}  // namespace glisson::studies
