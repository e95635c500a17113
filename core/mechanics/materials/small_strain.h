#pragma once
// Linear elasticity at small strain, as a function of F like the other materials. A turned body counts as strained:
// valid for small displacement gradients only.

#include "mechanics/materials/deformation.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

struct SmallStrain {
  Lame lame;

  [[nodiscard]] double energy_density_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Eigen::Matrix3d first_piola_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Matrix9d tangent_kPa(const Eigen::Matrix3d& f) const;
};

// The tangent at rest of every isotropic material: lambda I (x) I + mu (dF + dF^T).
[[nodiscard]] Matrix9d isotropic_tangent_kPa(const Lame& lame);

}  // namespace glisson::mechanics
