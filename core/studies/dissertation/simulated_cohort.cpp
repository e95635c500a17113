// A cohort of liver maps drawn to the figures of section 4.3.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "anatomy/patient.h"
#include "base/files.h"
#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "segmentation/rasterise.h"
#include "studies/dissertation/cohort.h"

namespace glisson::studies {
namespace {

// Voxels around the surface; slices as far apart as the dissertation's scans have them.
imaging::Grid grid_around(const geometry::Surface& surface) {
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  imaging::Grid grid;
  grid.spacing_mm = {3, 3, 10};
  grid.origin_mm = box.min_mm - grid.spacing_mm;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((box.max_mm - box.min_mm)[axis] / grid.spacing_mm[axis])) + 3;
  }
  return grid;
}

constexpr const char* simulated_note = "SIMULATED.txt";

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

imaging::Volume liver_map(const geometry::Surface& liver, double mean_kPa, std::mt19937& random) {
  imaging::Volume map{{grid_around(liver), {}}, "kPa"};
  const imaging::Mask mask = segmentation::rasterise(liver, map.grid);
  std::vector<float> field(map.grid.voxels());
  for (float& value : field) value = static_cast<float>(normal(random));
  field = imaging::gaussian_blur(std::move(field), map.grid, 12);

  std::vector<std::size_t> inside;
  double sum = 0;
  double squares = 0;
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (mask.values[v] == 0) continue;
    inside.push_back(v);
    sum += static_cast<double>(field[v]);
    squares += static_cast<double>(field[v]) * static_cast<double>(field[v]);
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

imaging::Volume simulated_liver_map(const geometry::Surface& liver, unsigned seed) {
  std::mt19937 random(seed);
  const double mean_kPa = mean_stiffness_kPa(random);
  return liver_map(liver, mean_kPa, random);
}

Result<void> write_simulated_cohort(const std::filesystem::path& folder, int patients, unsigned seed) {
  std::mt19937 random(seed);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  const std::string warning = "SIMULATED cohort, drawn to the distributions of the dissertation; nobody was measured\n";
  if (auto written = write_text_file(folder / simulated_note, warning); !written) return written;
  for (int patient = 1; patient <= patients; ++patient) {
    const double mean_kPa = mean_stiffness_kPa(random);
    anatomy::PatientOptions options;
    options.seed = static_cast<std::uint64_t>(seed - 1) * 100000 + static_cast<std::uint64_t>(patient);
    const auto liver = anatomy::make_liver_surface(options, 5);  // the maps' voxels are wider
    if (!liver) return failure(liver.error());
    const auto file = folder / fmt::format("simulated-{:03}-stiffness.nrrd", patient);
    if (auto written = imaging::write_volume_file(file, liver_map(*liver, mean_kPa, random)); !written) return written;
  }
  return {};
}

std::string cohort_warning(const std::filesystem::path& folder) {
  std::string text = read_text_file(folder / simulated_note).value_or("");
  return text.substr(0, text.find('\n'));
}

}  // namespace glisson::studies
