#pragma once
// A body with a fibre direction: transversely isotropic about one axis, at small strain, in one of two laws, both
// isotropic at ratio 1.
//
//   fibres       to the isotropic body come fibres that bear tension and compression along the axis,
//                (ratio - 1) E (a.eps a)^2 / 2: the shear moduli stay, and so does the resistance to a change of volume
//   engineering  E_axis = ratio E, the transverse modulus E, one Poisson's ratio nu = nu_axis,transverse =
//                nu_transverse, and the isotropic shear moduli, which is how programs for orthotropic bodies are
//                usually fed (e.g. Bower, Applied Mechanics of Solids, 3.2.12); not positive definite for ratios below
//                about (4 nu - 1) / (2 - 2 nu)
//
// In both the shear modulus in planes along the axis is `shear_ratio` times the isotropic one. A body that hardly
// changes its volume has no more constants than these three (Spencer, Continuum Theory of the Mechanics of
// Fibre-Reinforced Composites, 1984, 1.3).

#include <Eigen/Core>

#include "base/result.h"
#include "mechanics/materials/deformation.h"

namespace glisson::mechanics {

enum class AnisotropyLaw { fibres, engineering };

struct TransverseIsotropy {
  AnisotropyLaw law = AnisotropyLaw::fibres;
  Eigen::Vector3d axis{0, 0, 1};  // of any length but zero
  double ratio = 1;               // of Young's modulus along the axis to that across it
  double shear_ratio = 1;         // of the shear modulus along the axis to that across it
};

// Fails with "grain-invalid": an axis of no length, or ratios that are not above zero. A ratio is refused too that is
// so low that the body would give energy back when it is strained.
Result<void> check_anisotropy(const TransverseIsotropy& anisotropy, double poisson_ratio);

// Stress by displacement gradient, per unit of Young's modulus across the fibres.
[[nodiscard]] Matrix9d unit_tangent(const TransverseIsotropy& anisotropy, double poisson_ratio);

}  // namespace glisson::mechanics
