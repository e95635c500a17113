#pragma once
// Equilibrium straight from measured strain and stress (material_data.h), by He and Chen's locally convex data-driven
// solver, itself after T. Kirchdoerfer and M. Ortiz, Data-driven computational mechanics, Comput. Methods Appl. Mech.
// Eng. 304, 2016. Two steps alternate until they agree:
//
//   local    every integration point's state (strain, stress) goes to the nearest state that the data know;
//   global   of all compatible strains and balanced stresses, those nearest to the data's states: two solves with the
//            stiffness of the energy norm's metric, which is factorised once.
//
// Small strain, quadratic tetrahedra, one material. The metric only weighs and says where to start; a law of the tissue
// enters nowhere. A foundation's springs keep their own law t = k u. Their states (u, t) lie on that line, in the norm
// k |u|^2 / 2 + |t|^2 / (2 k). They take part in both steps.

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/materials/material_data.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

struct DataDrivenOptions {
  double relative_tolerance = 1e-5;  // of the displacements' change from one round to the next
  // Nor does a state look farther when all of them lie this near to the data (of their size, in the energy norm). Noisy
  // measurements lie apart by more.
  double close_enough = 1e-3;
  int max_rounds = 1000;  // they gain a factor of 2 a round where the data have the metric's slope, less where they are
                          // much stiffer or softer
};

struct DataDrivenResult {
  StaticResult result;            // `relative_residual`: the last change of the displacements over them
  std::vector<double> distances;  // after each round: from states to data, over the size of the states (energy norm)
  std::vector<double> von_mises_kPa;  // of each cell's mean stress
  double share_beyond_data = 0;       // of the body's volume: strained farther than was measured; a note says so
};

// What is fixed stays. Failures: those of StaticModel ("not-available" for ligaments).
Result<DataDrivenResult> find_equilibrium_from_data(const geometry::TetMesh& mesh, const MaterialData& data,
                                                    const std::vector<Support>& supports, const Loads& loads,
                                                    double density_kg_mm3, const DataDrivenOptions& options = {},
                                                    const Progress& progress = {});

}  // namespace glisson::mechanics
