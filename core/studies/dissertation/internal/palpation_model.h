#pragma once
// The model under test: a specimen's mesh with the moduli that elastography finds, pressed by the program's own ball.

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "elastography/cell_stiffness.h"
#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "studies/dissertation/internal/palpation_specimen.h"

namespace glisson::studies {

// Tetrahedra of a round gel, finer towards the axis of its top.
struct PalpationMesh {
  int across = 12;  // bricks of six tetrahedra
  int high = 4;     // even, so that the strata meet at faces
  double grading = 1.8;
};
[[nodiscard]] geometry::TetMesh palpation_mesh(const PalpationSpecimen& specimen, const PalpationMesh& mesh = {});

// Young's modulus of each cell as the program reads it from a simulated scan of the specimen: waves in closed form
// (elastography/wave_phantom.h), noise, inversion, and the confident voxels mapped to cells. Failures: invert's and
// cell_stiffness'.
Result<elastography::CellStiffness> elastography_of(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh,
                                                    const PalpationScan& scan, double poisson_ratio,
                                                    const Progress& progress = {});

// The body at rest and pressed, one surface each with the same points.
struct PressedPhantom {
  geometry::Surface rest, pressed;
  double depth_mm = 0;        // of the ball's lowest point below the top at rest
  double largest_strain = 0;  // in magnitude
};

// A neo-Hookean body, held at its bottom, under a smooth ball that is pushed down the axis by a force (simulation.h).
// Failures: simulate's, and "palpation-not-converged".
Result<PressedPhantom> press(geometry::TetMesh mesh, std::vector<double> youngs_kPa, double poisson_ratio,
                             double ball_radius_mm, double force_N, const Progress& progress = {});

}  // namespace glisson::studies
