#pragma once
// CHOLMOD stores a supernode's columns as one rectangle, and so the upper triangle of its square in zeros. Of the last
// separators of a body in three dimensions that is a quarter of the whole factor.

#include <cholmod.h>

namespace glisson::mechanics {

// Splits supernodes that are wider than `widest` into panels of about that width, which waste less. `factor` is
// supernodal and analysed, without numbers yet. Where memory is short it stays as it is: it is right either way.
void split_wide_supernodes(cholmod_factor& factor, int widest, cholmod_common& common);

}  // namespace glisson::mechanics
