#pragma once
// Linear elasticity in the frame that turns with the material. With F = R S (deformation.h):
//   energy = mu |S - I|^2 + lambda/2 tr(S - I)^2,   P = 2 mu (F - R) + lambda tr(S - I) R.
// On a linear tetrahedron its force is that of warped stiffness, R K (R^T x - X). R comes from the polar decomposition
// (Mueller and Gross 2004, Interactive Virtual Materials; Sifakis and Barbic, SIGGRAPH 2012 course, 3.4). Good for
// large rotations at moderate strain; it resists compression to nothing with a finite stress only.

#include "mechanics/materials/deformation.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

struct Corotational {
  Lame lame;

  [[nodiscard]] double energy_density_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Eigen::Matrix3d first_piola_kPa(const Eigen::Matrix3d& f) const;
  // Exact, with the turning of R; not positive definite everywhere.
  [[nodiscard]] Matrix9d tangent_kPa(const Eigen::Matrix3d& f) const;
  // As if R stayed: the stiffness of linear elasticity, turned. Positive semi-definite, and what interactive codes use.
  [[nodiscard]] Matrix9d warped_tangent_kPa(const Eigen::Matrix3d& f) const;
};

}  // namespace glisson::mechanics
