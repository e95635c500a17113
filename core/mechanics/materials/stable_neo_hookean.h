#pragma once
// Compressible Neo-Hookean elasticity that stays finite and keeps pushing back when a cell is crushed flat or turned
// inside out: B. Smith, F. de Goes, T. Kim 2018, Stable Neo-Hookean Flesh Simulation, ACM TOG 37(2), eq. 14:
//   energy = mu/2 (I_C - 3) + lambda/2 (J - alpha)^2 - mu/2 log(I_C + 1),   alpha = 1 + mu/lambda - mu/(4 lambda),
// I_C = |F|^2, J = det F. Its mu is 4/3 of Lame's, and its lambda is Lame's plus 5/6 of his mu (their section 3.4). So
// it agrees with linear elasticity at small strain. Shifted here by a constant to be zero at rest. Needs lambda + 5/6
// mu > 0 (Poisson's ratio above -1/2 or so); auxetic bodies are not its subject.

#include "mechanics/materials/deformation.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

class StableNeoHookean {
 public:
  explicit StableNeoHookean(const Lame& lame);

  [[nodiscard]] double energy_density_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Eigen::Matrix3d first_piola_kPa(const Eigen::Matrix3d& f) const;
  [[nodiscard]] Matrix9d tangent_kPa(const Eigen::Matrix3d& f) const;
  // All moduli that many times as large.
  [[nodiscard]] StableNeoHookean scaled(double factor) const;

 private:
  double mu_kPa_, lambda_kPa_, alpha_;
};

}  // namespace glisson::mechanics
