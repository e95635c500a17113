#pragma once
// Local frequency estimation: the wavelength around each voxel, from how strongly two or more overlapping band-pass
// filters answer. Source: Knutsson, Westin and Granlund, "Local multiscale frequency and bandwidth estimation", Proc.
// IEEE International Conference on Image Processing 1994; for elastography Manduca et al., Medical Image Analysis
// 5:237, 2001). The filters are lognormal, R_i(q) = exp(-C ln^2(q / q_i)) with q_(i+1) = 2 q_i. For one wave of spatial
// frequency q
//
//   ln q = ln sqrt(q_i q_(i+1)) + ln(R_(i+1)(q) / R_i(q)) / (2 C ln 2)
//
// and with C = 1 / (2 ln 2) the quotient of two neighbours' answers times the geometric mean of their centres is q
// itself. Estimates of all neighbours are averaged with the lower one's answer for weight. What noise adds to each
// answer is known from its variance and taken off first; it would make waves look short.
//
// Each filter is split into half-planes of directions (cosine squared). Where a wave meets its own reflection the whole
// has nodes, and neither of the two has. Derivatives are not formed, so that noise does little. But detail smaller than
// about half a wavelength is lost, and near a border the estimate is biased.

#include <vector>

#include "elastography/waves.h"

namespace glisson::elastography {

struct LocalFrequency {
  std::vector<float> wavelength_mm;  // one a voxel; 0 where there is no wave
  std::vector<float> amplitude;      // of the wave that was seen by the filters, in the waves' unit
  std::vector<float> above_noise;    // that amplitude over the noise's in the same band
};

// Tissue has shear waves between 0.5 and 8 m/s (0.25 and 64 kPa). The bands lie between the wavelengths of the slowest
// and the fastest, as far as the image can hold them. An image holds wavelengths of three voxels to twice its width.
// Slices are filtered one by one below 10 of them, and as a volume from there on.
[[nodiscard]] LocalFrequency local_frequency(const Waves& waves);

// The wavelength that divides the wave's energy in the signal into halves; 0 where there is none.
[[nodiscard]] double typical_wavelength_mm(const LocalFrequency& found, const imaging::Mask& signal);

}  // namespace glisson::elastography
