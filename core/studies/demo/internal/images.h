#pragma once
// The brightness that an MR scanner would give the demo patient's tissues. SIMULATED.

#include <cstdint>

#include "imaging/image.h"
#include "studies/demo/anatomy.h"

namespace glisson::studies {

enum class Contrast {
  portal_venous_t1,  // T1-weighted gradient echo, fat-suppressed, 70 s after the contrast agent: veins bright
  elastography       // magnitude of the motion-encoded echo-planar images: fluid bright, blurred, noisy
};

// Arbitrary units; healthy liver near 270 (T1) or 150 (elastography). There is partial volume across each slice and
// within it, and the coils' uneven sensitivity. Rician noise (Gudbjartsson and Patz 1995) is 30 or 14 times weaker than
// the liver's signal.
[[nodiscard]] imaging::Volume simulate_image(const DemoAnatomy& anatomy, const imaging::Grid& grid, Contrast contrast,
                                             std::uint64_t seed);

}  // namespace glisson::studies
