#include "elastography/internal/helmholtz.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/result.h"
#include "imaging/filters.h"

namespace glisson::elastography {
namespace {

// The sums of the quotient, one a voxel, each divided by the variance that noise gives the Laplacian: so frequencies
// count by what they tell.
struct Sums {
  std::vector<float> wave;                   // w^4 |u|^2
  std::vector<std::complex<float>> product;  // -w^2 conj(u) laplacian u
  std::vector<float> laplacian;              // |laplacian u|^2

  explicit Sums(std::size_t voxels) : wave(voxels, 0), product(voxels, 0), laplacian(voxels, 0) {}
};

// What the averaging over neighbours leaves of the noise's variance. White noise smoothed by a Gaussian of standard
// deviation s has a Laplacian of variance proportional to s^-(D + 4) in D dimensions; averaging with the same Gaussian
// again makes s larger by the square root of 2. Taken as if in two dimensions, since slices are often few.
constexpr double averaging_leaves = 1.0 / 8;

void add(const Waves& waves, const LocalFitter& fitter, Sums& sums);
void average(Sums& sums, const imaging::Grid& grid, double sd_mm);

}  // namespace

float trust_at_support(float support) {
  const float inwards = std::clamp((support - 0.5F) / 0.35F, 0.0F, 1.0F);
  return inwards * inwards * (3 - 2 * inwards);
}

VoxelModulus invert_helmholtz(const std::vector<Waves>& waves, const std::vector<double>& smoothing_mm,
                              FitDimension dimension) {
  GLISSON_ASSERT(!waves.empty() && waves.size() == smoothing_mm.size());
  const std::size_t voxels = waves.front().grid.voxels();
  Sums sums(voxels);
  std::vector<float> support(voxels, 1);
  imaging::Mask fitted = waves.front().signal;
  for (std::size_t f = 0; f < waves.size(); ++f) {
    const LocalFitter fitter(waves[f].signal, smoothing_mm[f], dimension);
    add(waves[f], fitter, sums);
    for (std::size_t v = 0; v < voxels; ++v) {
      support[v] = std::min(support[v], fitter.support()[v]);
      fitted.values[v] = fitted.values[v] != 0 && fitter.fitted().values[v] != 0 ? 1 : 0;
    }
  }
  // A node of the wave says nothing of the modulus; its neighbours do.
  average(sums, waves.front().grid, *std::min_element(smoothing_mm.begin(), smoothing_mm.end()));

  VoxelModulus found{std::vector<std::complex<float>>(voxels, 0), std::vector<float>(voxels, 0)};
  for (std::size_t v = 0; v < voxels; ++v) {
    const auto product = std::complex<double>(sums.product[v]);
    const auto wave = static_cast<double>(sums.wave[v]);
    const auto laplacian = static_cast<double>(sums.laplacian[v]);
    if (fitted.values[v] == 0 || !(wave > 0) || !(laplacian > 0) || !(std::norm(product) > 0)) continue;
    const std::complex<double> modulus = tissue_density_kg_mm3 * wave / product;
    if (!(modulus.real() > 0) || !std::isfinite(std::abs(modulus))) continue;
    const double coherence = std::min(1.0, std::norm(product) / (wave * laplacian));
    const double relative_variance = averaging_leaves * wave / std::norm(product);
    found.modulus_kPa[v] = std::complex<float>(modulus);
    found.confidence[v] =
        static_cast<float>(coherence / (1 + relative_variance / (0.15 * 0.15))) * trust_at_support(support[v]);
  }
  return found;
}

namespace {

void add(const Waves& waves, const LocalFitter& fitter, Sums& sums) {
  const std::size_t voxels = waves.grid.voxels();
  const double omega = 2 * std::numbers::pi * waves.frequency_Hz;
  const double omega2 = omega * omega;
  float strongest = 0;
  for (const ComplexField& u : waves.components) {
    for (std::size_t v = 0; v < voxels; ++v) {
      if (waves.signal.values[v] != 0) strongest = std::max(strongest, std::abs(u[v]));
    }
  }
  // Below rounding no noise is small enough to be believed.
  const float minimum_noise = 1e-5F * strongest + 1e-12F;
  for (const ComplexField& u : waves.components) {
    const LocalFit fit = fitter.fit(u);
    for (std::size_t v = 0; v < voxels; ++v) {
      if (fitter.fitted().values[v] == 0) continue;
      const double noise = static_cast<double>(std::max(waves.noise_rad[v], minimum_noise));
      const double variance = 2 * noise * noise;
      const LocalFitter::NoiseGain& gain = fitter.noise_gain()[v];
      const auto value = std::complex<double>(fit.value[v]);
      const auto laplacian = std::complex<double>(fit.laplacian[v]);
      const double of_laplacian = variance * static_cast<double>(gain.laplacian);
      if (!(of_laplacian > 0)) continue;
      const double wave = std::norm(value) - variance * static_cast<double>(gain.value);
      const std::complex<double> product = -std::conj(value) * laplacian + variance * static_cast<double>(gain.between);
      sums.wave[v] += static_cast<float>(omega2 * omega2 * wave / of_laplacian);
      sums.product[v] += std::complex<float>(omega2 * product / of_laplacian);
      sums.laplacian[v] += static_cast<float>(std::norm(laplacian) / of_laplacian - 1);
    }
  }
}

void average(Sums& sums, const imaging::Grid& grid, double sd_mm) {
  std::vector<float> real(sums.product.size());
  std::vector<float> imaginary(sums.product.size());
  for (std::size_t v = 0; v < sums.product.size(); ++v) {
    real[v] = sums.product[v].real();
    imaginary[v] = sums.product[v].imag();
  }
  sums.wave = imaging::gaussian_blur(std::move(sums.wave), grid, sd_mm);
  sums.laplacian = imaging::gaussian_blur(std::move(sums.laplacian), grid, sd_mm);
  real = imaging::gaussian_blur(std::move(real), grid, sd_mm);
  imaginary = imaging::gaussian_blur(std::move(imaginary), grid, sd_mm);
  for (std::size_t v = 0; v < sums.product.size(); ++v) sums.product[v] = {real[v], imaginary[v]};
}

}  // namespace
}  // namespace glisson::elastography
