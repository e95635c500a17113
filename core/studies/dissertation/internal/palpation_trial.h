#pragma once
// One trial: what is true of a pressed specimen, and what the model says of it.

#include "base/progress.h"
#include "base/result.h"
#include "studies/dissertation/internal/palpation_scan.h"
#include "studies/dissertation/internal/palpation_specimen.h"
#include "studies/dissertation/palpation.h"

namespace glisson::studies {

// What is true of the specimen with the fault's law and Poisson's ratio, up to each of the forces (ascending).
Result<PressCurve> truth_of(const PalpationSpecimen& specimen, PalpationFault fault, double ball_radius_mm,
                            const std::vector<double>& forces_N, const PressOptions& options = {},
                            const Progress& progress = {});

// What a trial is judged by, and what elastography told the model before it.
struct PalpationFacts {
  const std::vector<Eigen::Vector2d>& rest_profile_mm;
  const PressedProfile& pressed;
  const elastography::CellStiffness& found;  // of palpation_mesh of the options
  bool told_too = false;                     // is the model to be asked with the true moduli as well?
  unsigned scan_seed = 1;
};

// A row as PalpationSummary says. Failures: those of press and compare.
Result<NamedNumbers> judged_trial(const PalpationSpecimen& specimen, const PalpationTrial& trial,
                                  const PalpationFacts& facts, const PalpationOptions& options,
                                  const Progress& progress = {});

// The same of scans that were given; the model has the compounds' moduli that the options say.
Result<NamedNumbers> compared_trial(const PalpationSpecimen& specimen, const PalpationTrial& trial,
                                    const PalpationOptions& options, const PalpationScans& scans,
                                    const Progress& progress = {});

}  // namespace glisson::studies
