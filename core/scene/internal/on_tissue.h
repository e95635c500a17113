#pragma once
// Colours for values that are drawn over a laparoscope's video.

#include "scene/colour.h"

namespace glisson::scene {

// The colour at `fraction` of the way from the low end (0) to the high end (1), clamped outside. It goes from blue over
// cyan to a light green, the hues that no tissue has, as saturated as a screen can. It gets lighter in steps that are
// even by CIEDE2000. So it reads in grey, and to people with any of the common colour-vision deficiencies. At the heat
// mesh's opacity nineteen twentieths of a laparoscope's picture of the liver differ by 25 and more from what is under
// it (tests/scene/on_tissue_test.cpp). With viridis, whose low end is purple, it is less than 20.
[[nodiscard]] Colour colour_on_tissue(double fraction);

}  // namespace glisson::scene
