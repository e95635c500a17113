#pragma once
// Hyperelastic laws by their principal stretches, for Young's modulus 1 and free of the declared model's small strain:
//   W = w(e) + kappa/2 (J - 1)^2,   e_i = ln lambda_i - ln J / 3,
// with the shear and bulk moduli of the declared Young's modulus and Poisson's ratio at rest:
//   Yeoh    w = mu/2 ((I - 3) + b/2 (I - 3)^2),  I = sum exp(2 e_i)                O. H. Yeoh 1993, cut after two terms
//   Ogden   w = 2 mu / a^2 (sum exp(a e_i) - 3)                                     R. W. Ogden 1972, one term
// Neo-Hookean for b = 0 and for a = 2. Stress and tangent follow in the frame of the stretches, F = U diag(lambda) V^T
// (e.g. A. Stomakhin et al. 2012, Energetically Consistent Invertible Elasticity, section 4).

#include <Eigen/Core>

namespace glisson::closedloop {

enum class StretchLaw { yeoh, ogden };

struct StretchMaterial {
  StretchLaw law = StretchLaw::yeoh;
  double coefficient = 0;  // b or a
  double shear = 0;        // mu and kappa, per unit of Young's modulus
  double bulk = 0;
};
[[nodiscard]] StretchMaterial stretch_material(StretchLaw law, double coefficient, double poisson_ratio);

// A deformation gradient in its principal frame, with what stress and tangent need. Not a number where J <= 0.
struct PrincipalState {
  Eigen::Matrix3d left, right;      // U, V
  Eigen::Vector3d stress;           // dW / d lambda_i
  Eigen::Matrix3d normal_tangent;   // d2 W / d lambda_i d lambda_j
  Eigen::Vector3d symmetric, skew;  // of the pairs (1,2), (2,0), (0,1)
};
[[nodiscard]] PrincipalState principal_state(const StretchMaterial& material, const Eigen::Matrix3d& f);

// First Piola-Kirchhoff stress, per unit of Young's modulus, and its change as F changes.
[[nodiscard]] Eigen::Matrix3d stress_of(const PrincipalState& state);
[[nodiscard]] Eigen::Matrix3d stress_change(const PrincipalState& state, const Eigen::Matrix3d& f_change);

}  // namespace glisson::closedloop
