#pragma once
// How much of a deflection is missing at which resolution: section 6.3.2 and figure 6.5 of the dissertation, with this
// project's own meshfree engine.
//
// The cantilever of table 6.1 (50 x 10 x 10 mm, 12 kPa, 997 kg/m3) carries a load spread evenly along it. It is
// computed at volumes of 1.65 to 165 mm3 a node. Theory is eq. 6.6, w(x) = f x^2 (6 L^2 - 4 L x + x^2) / (24 E I).
// Timoshenko's deflection by shear is added, f (L x - x^2 / 2) / (kappa G A). Eq. 6.6 leaves that out, and it is 3 %
// here: a three-dimensional body converges to the sum. The table does not say the load or Poisson's ratio. The load is
// the beam's own weight, and the ratio 0, at which the wall has no end effect. Small strain, as in the theory.

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::studies {

struct ConvergenceOptions {
  double finest_mm3 = 1.65;  // a voxel of MR images: the dissertation's
  // The dissertation ends at 165 mm3, after ten resolutions. These are ten as far, evenly spaced in the logarithm, and
  // four more at the same ratio, up to some five nodes in the beam. So coarse accuracies have a resolution of their
  // own.
  double coarsest_mm3 = 1277.53;
  int resolutions = 14;
};

struct ConvergenceRow {
  double resolution_mm3 = 0;  // volume of the beam over its nodes
  int nodes = 0;
  std::size_t unknowns = 0;
  double tip_mm = 0;
  double error_mm = 0;         // of the axis at the tip, against theory with shear
  double error_eq_6_6_mm = 0;  // against eq. 6.6 alone
  double rms_error_mm = 0;     // over the axis, against theory with shear
  int iterations = 0;
  double relative_residual = 0;
  double setup_s = 0, solve_ms = 0;
};

struct ConvergenceStudy {
  double theory_tip_mm = 0;
  double eq_6_6_tip_mm = 0;
  std::vector<ConvergenceRow> rows;  // the finest first
};

// Failures: "study-options" (a number out of range), those of the engine; "not-converged".
Result<ConvergenceStudy> run_convergence(const ConvergenceOptions& options, const Progress& progress = {});

// convergence.csv, summary.json, report.html and convergence.json, which `platform --convergence` reads: the rows whose
// error grows with the resolution, as that format asks.
Result<void> write_convergence(const std::filesystem::path& out, const ConvergenceStudy& study);

}  // namespace glisson::studies
