#pragma once
// Whether a body under a load would give way sideways, which linear elasticity by itself never shows.

#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

// At least how many times the load of `result`, one of the model's, exceeds the one at which the body buckles. At 1 or
// less it stands, as far as was looked. The load factor s at which a bifurcation begins solves
//   (K + s K_sigma) v = 0,   v.K_sigma v = integral of sigma_ij v_k,i v_k,j,
// with sigma the linear stress (linearised buckling; Bathe, Finite Element Procedures, 6.8.2). Lanczos' method in the
// product with K approaches 1/s from below. So an answer above 1 is certain, and one below is not. It costs a dozen
// solves. 0 for an anisotropic body, whose stress is another.
[[nodiscard]] double load_beyond_buckling(const StaticModel& model, const StaticResult& result);

}  // namespace glisson::mechanics
