#pragma once
// Materials whose energy is split into change of shape and change of volume:
//   energy = w(I1, I2) + K/2 (J - 1)^2,   I1 = J^(-2/3) |F|^2,   I2 = J^(-4/3) (|F|^4 - |F^T F|^2) / 2.
// Neo-Hookean in this form is what CalculiX and Abaqus compute. Veronda-Westmann's law stiffens exponentially with
// strain, as soft tissue does (Veronda and Westmann 1970, J. Biomech. 3:111-124). All are for bodies that keep J > 0:
// at J <= 0 the energy is infinite, and a solver must not step there.

#include "mechanics/materials/deformation.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

// w = mu/2 (I1 - 3).
struct NeoHookean {
  double shear_kPa = 0;
  double bulk_kPa = 0;

  [[nodiscard]] double energy_density_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Eigen::Matrix3d first_piola_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Matrix9d tangent_kPa(const Eigen::Matrix3d& f) const;
};

// w = c1 (exp(c2 (I1 - 3)) - 1) - c1 c2 / 2 (I2 - 3). Its shear modulus at rest is c1 c2, which is what is given here.
// `stiffening`, c2, alone says how soon it stiffens: by 10 % where I1 - 3 is about 0.1 / c2. In uniaxial strain beyond
// that it grows without bound.
struct VerondaWestmann {
  double shear_kPa = 0;  // at rest
  double stiffening = 0;
  double bulk_kPa = 0;

  [[nodiscard]] double energy_density_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Eigen::Matrix3d first_piola_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Matrix9d tangent_kPa(const Eigen::Matrix3d& f) const;
};

inline double bulk_from_lame(const Lame& lame) { return lame.lambda_kPa + 2.0 / 3.0 * lame.mu_kPa; }
inline NeoHookean neo_hookean_from(const Lame& lame) { return {lame.mu_kPa, bulk_from_lame(lame)}; }
inline VerondaWestmann veronda_westmann_from(const Lame& lame, double stiffening) {
  return {lame.mu_kPa, stiffening, bulk_from_lame(lame)};
}

}  // namespace glisson::mechanics
