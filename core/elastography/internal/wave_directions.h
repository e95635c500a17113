#pragma once
// Waves told apart by where they run. Source: Manduca, Lake, Kruse and Ehman, "Spatio-temporal directional filtering
// for improved inversion of MR elastography images", Medical Image Analysis 7:465, 2003. Where a wave meets its own
// reflection the whole has nodes, in which noise is all that is left; neither of the two has.
//
// The spectrum of a slice or a volume is weighted with the squared cosine between its spatial frequency and a
// direction. It is so on the half in which that is positive.

#include <array>
#include <vector>

#include "elastography/waves.h"

namespace glisson::elastography {

// The block that is filtered at once: a slice, or the whole volume from ten slices on; with room for what wraps around.
struct SpectrumBlock {
  std::array<int, 3> size;    // of the data
  std::array<int, 3> padded;  // of the transform
  int count;                  // how many of them the grid holds
};
[[nodiscard]] SpectrumBlock block_of(const imaging::Grid& grid);

// Spatial frequency (1/mm, along the image axes) of each sample of the transform.
[[nodiscard]] std::vector<Eigen::Vector3f> sample_frequencies(const SpectrumBlock& block, const imaging::Grid& grid);

// A weight for each sample, for each of six directions in a slice or of twelve in a volume.
[[nodiscard]] std::vector<std::vector<float>> direction_lobes(const SpectrumBlock& block,
                                                              const std::vector<Eigen::Vector3f>& frequencies);

// Block `number` of the data, 0 outside the signal and in the room around.
[[nodiscard]] ComplexField padded(const ComplexField& data, const std::vector<std::uint8_t>& signal,
                                  const SpectrumBlock& block, int number);

// Each component as several, one a direction, which together are the component again times a factor. The noise is what
// each of them keeps of it. Every one of them obeys the wave equation that the whole obeys.
[[nodiscard]] Waves running_apart(const Waves& waves);

}  // namespace glisson::elastography
