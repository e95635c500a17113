#pragma once
// A tissue that stiffens, at small strain, as a law. It has what it is measured to do in a test, and what a body of it
// does. It is the known truth beside which the data-driven study stands, found in another way: no measurement enters.

#include "geometry/tetrahedra.h"
#include "mechanics/materials/material_data.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/statics/static_result.h"

namespace glisson::studies {

// Isotropic. Volume change is linear, K = E / (3 (1 - 2 nu)). The deviators of stress and strain point the same way,
// and their lengths t and d follow
//   t = 2 mu d (1 + (d / d2)^2),   mu = E / (2 (1 + nu)),   d2 = sqrt(3/2) e2,
// so that stress over strain has doubled at about the axial strain e2 (Hencky's deformation theory with a cubic curve).
struct StiffeningTissue {
  double youngs_kPa = 6;    // at rest: a healthy liver's by MRE
  double doubles_at = 0.2;  // e2: our choice
  double poisson_ratio = usual_poisson_ratio;

  [[nodiscard]] Eigen::Matrix3d stress_kPa(const Eigen::Matrix3d& strain) const;
  // A uniaxial test where the deviator of strain has that length, negative in compression.
  [[nodiscard]] mechanics::StressStrain tested(double deviator_length) const;
  // The slope of t over d there, over that at rest.
  [[nodiscard]] double relative_tangent(double deviator_length) const;
};

// Equilibrium of a body of it (mm, mN, LPS): Newton's method with one fixed stiffness, that of the strain
// `farthest_deviator`, so that each step is a contraction up to twice the tangent there. Converged where the
// displacements change by less than 1e-7 of their size. Failures: StaticModel's.
Result<mechanics::StaticResult> equilibrium_of(const StiffeningTissue& tissue, double farthest_deviator,
                                               const geometry::TetMesh& mesh,
                                               const std::vector<mechanics::Support>& supports,
                                               const mechanics::Loads& loads);

}  // namespace glisson::studies
