#include "elastography/local_frequency.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "elastography/internal/fourier.h"
#include "elastography/internal/wave_directions.h"
#include "imaging/filters.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;

constexpr double slowest_mm_s = 500;
constexpr double fastest_mm_s = 8000;
constexpr double sharpness = 0.5 / std::numbers::ln2;  // C above

std::vector<double> band_centres(const Grid& grid, double frequency_Hz);
// Of the filters' answers, summed over components and directions.
struct BandEnergies {
  std::vector<std::vector<float>> energy;  // [band][voxel]
  std::vector<double> noise_gain;          // [band]: what white noise of variance 1 in each component gives
};
BandEnergies band_energies(const Waves& waves, const std::vector<double>& centres);

}  // namespace

LocalFrequency local_frequency(const Waves& waves) {
  const std::size_t voxels = waves.grid.voxels();
  const std::vector<double> centres = band_centres(waves.grid, waves.frequency_Hz);
  BandEnergies bands = band_energies(waves, centres);
  const double sd_mm = waves.grid.spacing_mm.head<2>().mean();
  for (auto& band : bands.energy) band = imaging::gaussian_blur(std::move(band), waves.grid, sd_mm);

  LocalFrequency found{std::vector<float>(voxels, 0), std::vector<float>(voxels, 0), std::vector<float>(voxels, 0)};
  std::vector<double> answer(centres.size());
  for (std::size_t v = 0; v < voxels; ++v) {
    if (waves.signal.values[v] == 0) continue;
    const auto noise = static_cast<double>(waves.noise_rad[v]);
    std::size_t strongest = 0;
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const double energy = static_cast<double>(bands.energy[i][v]) - 2 * noise * noise * bands.noise_gain[i];
      answer[i] = std::sqrt(std::max(0.0, energy));
      if (answer[i] > answer[strongest]) strongest = i;
    }
    double weight = 0;
    double sum = 0;
    for (std::size_t i = 0; i + 1 < centres.size(); ++i) {
      weight += answer[i];
      sum += std::sqrt(centres[i] * centres[i + 1]) * answer[i + 1];
    }
    if (!(weight > 0) || !(sum > 0)) continue;
    found.wavelength_mm[v] = static_cast<float>(weight / sum);
    found.amplitude[v] = static_cast<float>(answer[strongest]);
    const double floor = noise * std::sqrt(2 * bands.noise_gain[strongest]);
    found.above_noise[v] = static_cast<float>(std::min(1e6, answer[strongest] / std::max(floor, 1e-12)));
  }
  return found;
}

double typical_wavelength_mm(const LocalFrequency& found, const imaging::Mask& signal) {
  std::vector<std::pair<float, double>> weighted;
  double all = 0;
  for (std::size_t v = 0; v < found.wavelength_mm.size(); ++v) {
    if (signal.values[v] == 0 || !(found.wavelength_mm[v] > 0)) continue;
    const double energy = static_cast<double>(found.amplitude[v]) * static_cast<double>(found.amplitude[v]);
    weighted.emplace_back(found.wavelength_mm[v], energy);
    all += energy;
  }
  std::sort(weighted.begin(), weighted.end());
  double below = 0;
  for (const auto& [wavelength_mm, energy] : weighted) {
    below += energy;
    if (below >= 0.5 * all) return static_cast<double>(wavelength_mm);
  }
  return 0;
}

namespace {

std::vector<double> band_centres(const Grid& grid, double frequency_Hz) {
  const double widest_mm = std::max(grid.size[0] * grid.spacing_mm[0], grid.size[1] * grid.spacing_mm[1]);
  const double longest_mm = std::min(fastest_mm_s / frequency_Hz, 2 * widest_mm);
  const double shortest_mm = std::max(slowest_mm_s / frequency_Hz, 3 * grid.spacing_mm.head<2>().minCoeff());
  std::vector<double> centres;
  for (double centre = 1 / longest_mm; centre < 2 / shortest_mm || centres.size() < 2; centre *= 2) {
    centres.push_back(centre);
  }
  return centres;
}

BandEnergies band_energies(const Waves& waves, const std::vector<double>& centres) {
  const Grid& grid = waves.grid;
  const SpectrumBlock block = block_of(grid);
  const FourierTransform transform(block.padded);
  const auto frequencies = sample_frequencies(block, grid);
  const auto lobe = direction_lobes(block, frequencies);
  std::vector<std::vector<float>> band(centres.size(), std::vector<float>(frequencies.size(), 0));
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    const double q = static_cast<double>(frequencies[n].norm());
    if (!(q > 0)) continue;
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const double octaves = std::log(q / centres[i]);
      band[i][n] = static_cast<float>(std::exp(-sharpness * octaves * octaves));
    }
  }

  BandEnergies found{{centres.size(), std::vector<float>(grid.voxels(), 0)}, std::vector<double>(centres.size(), 0)};
  auto& energy = found.energy;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (const auto& weight : lobe) {
      for (std::size_t n = 0; n < weight.size(); ++n) {
        const auto response = static_cast<double>(band[i][n] * weight[n]);
        found.noise_gain[i] +=
            static_cast<double>(waves.components.size()) * response * response / static_cast<double>(weight.size());
      }
    }
  }
  const std::size_t slice = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  const auto width = static_cast<std::size_t>(block.padded[0]);
  const auto height = static_cast<std::size_t>(block.padded[1]);
  for (int number = 0; number < block.count; ++number) {
    for (const ComplexField& component : waves.components) {
      ComplexField spectrum = padded(component, waves.signal.values, block, number);
      transform.forward(spectrum);
      // Bands share nothing, so that each can be summed on its own thread.
      parallel_for(centres.size(), 1, [&](std::size_t begin, std::size_t end) {
        ComplexField answer(spectrum.size());
        for (std::size_t i = begin; i < end; ++i) {
          for (std::size_t d = 0; d < lobe.size(); ++d) {
            for (std::size_t n = 0; n < spectrum.size(); ++n) answer[n] = spectrum[n] * (band[i][n] * lobe[d][n]);
            transform.inverse(answer);
            for (std::size_t k = 0; k < static_cast<std::size_t>(block.size[2]); ++k) {
              for (std::size_t j = 0; j < static_cast<std::size_t>(block.size[1]); ++j) {
                float* const out = &energy[i][(static_cast<std::size_t>(number) + k) * slice +
                                              j * static_cast<std::size_t>(block.size[0])];
                const std::complex<float>* const in = &answer[width * (j + height * k)];
                for (int x = 0; x < block.size[0]; ++x) out[x] += std::norm(in[x]);
              }
            }
          }
        }
      });
    }
  }
  return found;
}

}  // namespace
}  // namespace glisson::elastography
