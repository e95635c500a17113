#pragma once
// Phase that was measured modulo one turn, over one period of a vibration: what the motion added to it, unwrapped.
//
// The still part of the phase (coils, field) is of no use and often wrapped many times. It falls out of the differences
// from one instant to the next, d[t] = phase[t + 1] - phase[t] around the period. A wave of A rad has differences of at
// most 2 A sin(pi / instants). Below A = 4.1 rad at eight instants each of them, taken into (-pi, pi], is therefore
// unwrapped already. Larger waves need their neighbours in space too. Around a whole period the differences of one
// voxel must come to nothing: where they do not, the voxel is not to be trusted.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::elastography {

enum class Unwrapping {
  in_time,        // differences in time only
  laplacian,      // then in space, by the Poisson equation (Ghiglia and Romero, JOSA A 11:107, 1994; solved by cosine
                  // transform), kept congruent with what was measured
  quality_guided  // then in space, along the most reliable paths first (Herraez et al., Applied Optics 41:7437, 2002,
                  // with second differences along the axes for reliability)
};

struct UnwrappedPhase {
  std::vector<std::vector<float>> phase_rad;  // [instant][voxel], mean over the instants zero
  std::vector<std::uint8_t> closed;           // one a voxel: whether the differences come to what they must
};

// wrapped_rad[instant][voxel] on the grid, at least three instants, evenly spread over one period. Voxels outside
// `signal` hold noise: no path runs through them, and they are unwrapped in time only.
[[nodiscard]] UnwrappedPhase unwrap(const std::vector<std::vector<float>>& wrapped_rad, const imaging::Mask& signal,
                                    Unwrapping method);

// Into [-pi, pi].
[[nodiscard]] float wrapped(float phase_rad);

}  // namespace glisson::elastography
