#pragma once
// Algebraic inversion: in a piece of tissue that is alike all around, each component of a shear wave obeys
//
//   G laplacian u + density w^2 u = 0
//
// with the complex shear modulus G = storage + i loss (Oliphant, Manduca, Ehman and Greenleaf, Magnetic Resonance in
// Medicine 45:299, 2001). Multiplied with conj(u) and summed over components, neighbours and, where several were
// measured, frequencies, G is a quotient of two sums. Noise adds to both what can be computed from its variance, and
// that is taken off. Without that the modulus comes out too small where the wave is weak. The equation does not hold
// across borders of different tissue; there the result is a mixture, and the confidence falls.

#include <complex>
#include <vector>

#include "elastography/internal/local_fit.h"
#include "elastography/waves.h"

namespace glisson::elastography {

// What is known of each voxel; 0 where nothing is.
struct VoxelModulus {
  std::vector<std::complex<float>> modulus_kPa;  // storage + i loss
  std::vector<float> confidence;                 // 0 to 1, see below
};

// The confidence is the product of three numbers from 0 to 1:
// - Their coherence: how nearly the Laplacian is proportional to the wave in the neighbourhood. It falls where the
//   equation does not hold.
// - 1 / (1 + (e / 0.15)^2), with e the relative standard error of the modulus that the noise makes.
// - How much of the fit's neighbourhood lies in the tissue, from 0 at an edge that stands out to 1 where 85 % do.
//
// smoothing_mm[f] is the standard deviation of the fit's weights for waves[f]. All waves lie on one grid.
[[nodiscard]] VoxelModulus invert_helmholtz(const std::vector<Waves>& waves, const std::vector<double>& smoothing_mm,
                                            FitDimension dimension);

// Of tissue, in kg/mm3: that of water, as all of elastography takes it.
constexpr double tissue_density_kg_mm3 = 1e-6;

// How confidence falls towards the border, by the part of the neighbourhood that lies in the tissue.
[[nodiscard]] float trust_at_support(float support);

}  // namespace glisson::elastography
