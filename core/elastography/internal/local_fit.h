#pragma once
// The value and the Laplacian of a noisy field, from a quadratic polynomial fitted around each voxel. The weights are
// Gaussian, over the voxels of a mask and no others (normalised convolution with a polynomial basis: Knutsson and
// Westin, CVPR 1993; Farneback, PhD thesis, Linkoping 2002).
//
// With p the fitted polynomial and s the Gaussian's standard deviation, what is given is not p and its Laplacian but
//
//   value     = p(0) + s^2/2 laplacian p        laplacian = laplacian p
//
// Where the whole neighbourhood is in the mask, these are exactly g * u and laplacian(g * u) for the Gaussian g. The
// smoothing damps both of a plane wave by the same factor. So their ratio is its wavenumber squared, without bias.
// Where the mask ends they stay consistent, as the fit does not look beyond it.

#include <cstdint>
#include <vector>

#include "elastography/waves.h"

namespace glisson::elastography {

enum class FitDimension {
  slice,  // within each slice, as if nothing changed along the normal
  volume
};

struct LocalFit {
  ComplexField value;
  ComplexField laplacian;  // 1/mm2 times the value's unit
};

class LocalFitter {
 public:
  LocalFitter(const imaging::Mask& mask, double sd_mm, FitDimension dimension);

  [[nodiscard]] LocalFit fit(const ComplexField& field) const;

  // Voxels where the fit exists: in the mask, with enough of it around.
  [[nodiscard]] const imaging::Mask& fitted() const { return fitted_; }

  // What part of the weights within the grid lies in the mask, one a voxel: 1 deep inside, about a half at a straight
  // border.
  [[nodiscard]] const std::vector<float>& support() const { return support_; }

  // How white noise of variance 1 comes out, one a voxel: variance of the value, covariance of value and Laplacian,
  // variance of the Laplacian.
  struct NoiseGain {
    float value, between, laplacian;
  };
  [[nodiscard]] const std::vector<NoiseGain>& noise_gain() const { return noise_gain_; }

 private:
  void solve(const std::vector<std::vector<float>>& moments, const std::vector<std::vector<float>>& squared_moments);

  imaging::Grid grid_;
  double sd_mm_;
  FitDimension dimension_;
  imaging::Mask mask_, fitted_;
  std::vector<float> support_;
  std::vector<NoiseGain> noise_gain_;
  std::vector<std::uint32_t> row_of_;               // of a fitted voxel in the two tables below
  std::vector<float> value_rows_, laplacian_rows_;  // [fitted voxel][basis function]
};

}  // namespace glisson::elastography
