#pragma once
// The slice kernels in vectors of 16-bit words, by Google Highway: compiled for every instruction set that the
// compiler knows, chosen when the program runs.

#include "registration/internal/trwls_slices.h"

namespace glisson::registration {

// For the widest instructions that this machine has.
[[nodiscard]] SliceKernels<std::uint16_t> simd_kernels();
[[nodiscard]] const char* simd_name();

}  // namespace glisson::registration
