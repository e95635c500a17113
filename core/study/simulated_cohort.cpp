// A cohort of liver maps drawn to the figures of section 4.3.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "study/cohort.h"

namespace glisson::study {
namespace {

// The slices of the dissertation's scans lie 10 mm apart; voxels are coarser here, since only statistics are drawn.
imaging::Grid liver_grid() {
  imaging::Grid grid;
  grid.size = {40, 32, 12};
  grid.spacing_mm = {5, 5, 10};
  return grid;
}

// Uniform in (0, 1), and normal, from the generator's bits: the standard library's distributions differ from one to the
// next, and the same seed must give the same cohort everywhere.
double uniform(std::mt19937& random) { return (static_cast<double>(random()) + 0.5) / 4294967296.0; }
double normal(std::mt19937& random) {
  return std::sqrt(-2 * std::log(uniform(random))) * std::cos(2 * std::numbers::pi * uniform(random));
}

// 64 % within 0.5 kPa of 2.1 kPa; the others above, falling off exponentially so that 2.5 % of all lie above 4.8 times
// the atlas's upper limit of 3.1 kPa.
double mean_stiffness_kPa(std::mt19937& random) {
  constexpr double typical_kPa = 2.1;
  constexpr double half_width_kPa = 0.5;
  constexpr double typical_fraction = 0.64;
  constexpr double upper_limit_kPa = 4.8 * 3.1;
  if (uniform(random) < typical_fraction) {
    for (;;) {
      const double kPa = typical_kPa + 0.5 * half_width_kPa * normal(random);
      if (std::abs(kPa - typical_kPa) <= half_width_kPa) return kPa;
    }
  }
  const double from_kPa = typical_kPa + half_width_kPa;
  const double length_kPa = (upper_limit_kPa - from_kPa) / std::log((1 - typical_fraction) / 0.025);
  return from_kPa - length_kPa * std::log(uniform(random));
}

imaging::Volume liver_map(double mean_kPa, std::mt19937& random) {
  imaging::Volume map{{liver_grid(), {}}, "kPa"};
  std::vector<float> field(map.grid.voxels());
  for (float& value : field) value = static_cast<float>(normal(random));
  field = imaging::gaussian_blur(std::move(field), map.grid, 12);

  std::vector<std::size_t> inside;
  double sum = 0;
  double squares = 0;
  for (int k = 0; k < map.grid.size[2]; ++k) {
    for (int j = 0; j < map.grid.size[1]; ++j) {
      for (int i = 0; i < map.grid.size[0]; ++i) {
        // An ellipsoid of about 1.4 litres.
        const double x = (i - 19.5) / 17;
        const double y = (j - 15.5) / 13;
        const double z = (k - 5.5) / 5;
        if (x * x + y * y + z * z > 1) continue;
        inside.push_back(map.grid.offset(i, j, k));
        sum += static_cast<double>(field[inside.back()]);
        squares += static_cast<double>(field[inside.back()]) * static_cast<double>(field[inside.back()]);
      }
    }
  }
  const auto count = static_cast<double>(inside.size());
  const double mean = sum / count;
  const double sd = std::sqrt(squares / count - mean * mean);
  // Lognormal, so that no stiffness is negative; with the wanted mean and spread.
  const double relative_sd = 0.95 / 2.1;
  const double log_sd = std::sqrt(std::log(1 + relative_sd * relative_sd)) * (1 + 0.1 * normal(random));
  map.values.assign(map.grid.voxels(), 0);
  for (const std::size_t v : inside) {
    const double standard = (static_cast<double>(field[v]) - mean) / sd;
    map.values[v] = static_cast<float>(mean_kPa * std::exp(log_sd * standard - 0.5 * log_sd * log_sd));
  }
  return map;
}

}  // namespace

Result<void> write_simulated_cohort(const std::filesystem::path& folder, int patients, unsigned seed) {
  std::mt19937 random(seed);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  for (int patient = 1; patient <= patients; ++patient) {
    const imaging::Volume map = liver_map(mean_stiffness_kPa(random), random);
    const auto file = folder / fmt::format("simulated-{:03}-stiffness.nrrd", patient);
    if (auto written = imaging::write_volume_file(file, map); !written) return written;
  }
  return {};
}

}  // namespace glisson::study
