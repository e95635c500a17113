#include "elastography/inversion.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "elastography/internal/helmholtz.h"
#include "elastography/internal/wave_directions.h"
#include "elastography/local_frequency.h"
#include "imaging/filters.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;
using imaging::Mask;
using imaging::Volume;

// The waves of one frequency, ready to be inverted.
struct Prepared {
  Waves waves;
  double wavelength_mm = 0;
};
Result<Prepared> prepare(const WaveImages& images, const InversionOptions& options, std::vector<Sentence>& notes);
Mask region_on(const Grid& grid, const std::optional<Mask>& organ, const std::vector<Prepared>& prepared);
VoxelModulus invert_direct(const std::vector<Prepared>& prepared, const Mask& region, const InversionOptions& options);
VoxelModulus invert_by_local_frequency(const std::vector<Prepared>& prepared, const Mask& region);
void take_time_forwards(VoxelModulus& found, std::vector<Sentence>& notes);
void fill_pictures(const Waves& waves, ModulusMap& map);
Result<void> summarise(ModulusMap& map, double minimum_confidence);

}  // namespace

std::string_view method_name(InversionMethod method) { return method == InversionMethod::direct ? "direct" : "lfe"; }

Result<ModulusMap> invert(const std::vector<WaveImages>& images, const std::optional<Mask>& organ,
                          const InversionOptions& options, const Progress& progress) {
  if (images.empty()) return failure("waves-none", GLISSON_TEXT("There are no wave or phase images."));
  ModulusMap map;
  map.method = options.method;
  std::vector<Prepared> prepared;
  for (std::size_t f = 0; f < images.size(); ++f) {
    if (progress.cancelled()) return cancelled();
    progress.report(0.6 * static_cast<double>(f) / static_cast<double>(images.size()),
                    GLISSON_TEXT("Unwrapping the phase"));
    auto one = prepare(images[f], options, map.notes);
    if (!one) return failure(one.error());
    map.frequencies_Hz.push_back(images[f].frequency_Hz);
    prepared.push_back(std::move(*one));
  }
  map.region = region_on(images.front().grid, organ, prepared);
  if (std::none_of(map.region.values.begin(), map.region.values.end(), [](auto inside) { return inside != 0; })) {
    return failure(Error{"waves-empty-organ",
                         GLISSON_TEXT("The waves give no signal inside the organ."),
                         {},
                         GLISSON_TEXT("Check that the segmentation and the wave images belong together."),
                         {}});
  }
  if (progress.cancelled()) return cancelled();
  progress.report(0.6, GLISSON_TEXT("Inverting the waves"));
  VoxelModulus found = options.method == InversionMethod::direct ? invert_direct(prepared, map.region, options)
                                                                 : invert_by_local_frequency(prepared, map.region);
  if (options.method == InversionMethod::direct) take_time_forwards(found, map.notes);

  const Grid& grid = images.front().grid;
  const auto volume = [&](const char* unit) { return Volume{{grid, std::vector<float>(grid.voxels(), 0)}, unit}; };
  map.magnitude_kPa = volume("kPa");
  map.confidence = Volume{{grid, std::move(found.confidence)}, ""};
  if (options.method == InversionMethod::direct) {
    map.storage_kPa = volume("kPa");
    map.loss_kPa = volume("kPa");
  }
  for (std::size_t v = 0; v < grid.voxels(); ++v) {
    map.magnitude_kPa.values[v] = std::abs(found.modulus_kPa[v]);
    if (!map.storage_kPa) continue;
    map.storage_kPa->values[v] = found.modulus_kPa[v].real();
    map.loss_kPa->values[v] = found.modulus_kPa[v].imag();
  }
  fill_pictures(prepared.front().waves, map);
  map.typical_wavelength_mm = prepared.front().wavelength_mm;
  if (auto summarised = summarise(map, options.minimum_confidence); !summarised) return failure(summarised.error());
  progress.report(1.0, GLISSON_TEXT("Inverted"));
  return map;
}

namespace {

Result<Prepared> prepare(const WaveImages& images, const InversionOptions& options, std::vector<Sentence>& notes) {
  Prepared prepared;
  prepared.waves = first_harmonic(images, tissue_of(images), options.unwrapping);
  if (prepared.waves.closed_fraction < 0.9) {
    notes.push_back({GLISSON_TEXT("At {0} Hz the phase of {1} % of the tissue does not come back to itself over a "
                                  "period; those voxels were left out."),
                     {fmt::format("{:g}", images.frequency_Hz),
                      fmt::format("{:.0f}", 100 * (1 - prepared.waves.closed_fraction))}});
  }
  if (options.long_waves == LongWaves::curl) {
    auto curl = curl_of(prepared.waves, images.along);
    if (!curl) return failure(curl.error());
    prepared.waves = std::move(*curl);
  }
  if (options.long_waves != LongWaves::keep) prepared.waves = without_swaying(std::move(prepared.waves));
  prepared.wavelength_mm = typical_wavelength_mm(local_frequency(prepared.waves), prepared.waves.signal);
  if (options.long_waves == LongWaves::high_pass && prepared.wavelength_mm > 0) {
    prepared.waves = without_long_waves(std::move(prepared.waves), 0.5 * prepared.wavelength_mm);
    prepared.wavelength_mm = typical_wavelength_mm(local_frequency(prepared.waves), prepared.waves.signal);
  }
  return prepared;
}

// Where all frequencies gave a signal, and inside the organ.
Mask region_on(const Grid& grid, const std::optional<Mask>& organ, const std::vector<Prepared>& prepared) {
  Mask region{grid, std::vector<std::uint8_t>(grid.voxels(), 1)};
  for (const Prepared& one : prepared) {
    for (std::size_t v = 0; v < region.values.size(); ++v) region.values[v] &= one.waves.signal.values[v];
  }
  if (!organ) return region;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Eigen::Vector3d at = organ->grid.index_of(grid.position_mm(i, j, k)).array().round();
        const Eigen::Vector3i index = at.cast<int>();
        const bool inside =
            organ->grid.contains(index.x(), index.y(), index.z()) && organ->at(index.x(), index.y(), index.z()) != 0;
        if (!inside) region.at(i, j, k) = 0;
      }
    }
  }
  return region;
}

VoxelModulus invert_direct(const std::vector<Prepared>& prepared, const Mask& region, const InversionOptions& options) {
  std::vector<Waves> waves;
  std::vector<double> smoothing_mm;
  for (const Prepared& one : prepared) {
    waves.push_back(options.directions == Directions::apart ? running_apart(one.waves) : one.waves);
    waves.back().signal = region;
    const double voxel_mm = region.grid.spacing_mm.head<2>().maxCoeff();
    smoothing_mm.push_back(
        std::max(options.smoothing_wavelengths * one.wavelength_mm, options.minimum_smoothing_voxels * voxel_mm));
  }
  const auto dimension =
      region.grid.size[2] >= options.minimum_slices_of_a_volume ? FitDimension::volume : FitDimension::slice;
  return invert_helmholtz(waves, smoothing_mm, dimension);
}

// The slowness of several frequencies is averaged, each counting by its amplitude over its noise.
VoxelModulus invert_by_local_frequency(const std::vector<Prepared>& prepared, const Mask& region) {
  const std::size_t voxels = region.grid.voxels();
  std::vector<double> weight(voxels, 0);
  std::vector<double> slowness(voxels, 0);  // weighted, s/mm
  std::vector<double> longest_mm(voxels, 0);
  for (const Prepared& one : prepared) {
    const LocalFrequency found = local_frequency(one.waves);
    for (std::size_t v = 0; v < voxels; ++v) {
      const auto wavelength_mm = static_cast<double>(found.wavelength_mm[v]);
      if (region.values[v] == 0 || !(wavelength_mm > 0)) continue;
      const auto told = static_cast<double>(found.above_noise[v]);
      weight[v] += told;
      slowness[v] += told / (one.waves.frequency_Hz * wavelength_mm);
      longest_mm[v] = std::max(longest_mm[v], wavelength_mm);
    }
  }
  const std::vector<float> squared_mm2 = imaging::squared_depths_mm2(region);

  VoxelModulus found{std::vector<std::complex<float>>(voxels, 0), std::vector<float>(voxels, 0)};
  for (std::size_t v = 0; v < voxels; ++v) {
    if (!(weight[v] > 0)) continue;
    const double speed_mm_s = weight[v] / slowness[v];
    found.modulus_kPa[v] = static_cast<float>(tissue_density_kg_mm3 * speed_mm_s * speed_mm_s);
    // The filters reach a good quarter of a wavelength; a wave no stronger than the noise has no frequency.
    const double inwards = std::sqrt(static_cast<double>(squared_mm2[v])) / (0.25 * longest_mm[v]);
    const double strength = weight[v] / static_cast<double>(prepared.size());
    found.confidence[v] = static_cast<float>(std::clamp(inwards, 0.0, 1.0) / (1 + 4 / (strength * strength)));
  }
  return found;
}

// No tissue gives energy to a wave. Where the loss comes out negative throughout, the offsets were stored backwards in
// time, which no header says.
void take_time_forwards(VoxelModulus& found, std::vector<Sentence>& notes) {
  double loss = 0;
  for (std::size_t v = 0; v < found.confidence.size(); ++v) {
    const std::complex<float> modulus = found.modulus_kPa[v];
    if (modulus.real() > 0) loss += static_cast<double>(found.confidence[v] * modulus.imag() / std::abs(modulus));
  }
  if (loss >= 0) return;
  for (auto& modulus : found.modulus_kPa) modulus = std::conj(modulus);
  notes.push_back(
      {GLISSON_TEXT("The loss came out negative, as when the instants run backwards in time; its sign was turned."),
       {}});
}

void fill_pictures(const Waves& waves, ModulusMap& map) {
  const std::size_t voxels = waves.grid.voxels();
  map.amplitude_rad = Volume{{waves.grid, std::vector<float>(voxels, 0)}, "rad"};
  map.wave_rad = map.amplitude_rad;
  double strongest = -1;
  for (const ComplexField& u : waves.components) {
    double energy = 0;
    for (std::size_t v = 0; v < voxels; ++v) {
      if (waves.signal.values[v] == 0) continue;
      map.amplitude_rad.values[v] += std::norm(u[v]);
      if (map.region.values[v] != 0) energy += static_cast<double>(std::norm(u[v]));
    }
    if (energy <= strongest) continue;
    strongest = energy;
    map.moving_wave_rad = u;
    for (std::size_t v = 0; v < voxels; ++v) {
      if (waves.signal.values[v] == 0) map.moving_wave_rad[v] = 0;
      map.wave_rad.values[v] = map.moving_wave_rad[v].real();
    }
  }
  for (float& amplitude : map.amplitude_rad.values) amplitude = std::sqrt(amplitude);
}

Result<void> summarise(ModulusMap& map, double minimum_confidence) {
  std::size_t region = 0;
  std::vector<double> magnitude;
  double storage = 0;
  double loss = 0;
  for (std::size_t v = 0; v < map.region.values.size(); ++v) {
    region += map.region.values[v] != 0 ? 1 : 0;
    if (map.confidence.values[v] < static_cast<float>(minimum_confidence)) continue;
    magnitude.push_back(static_cast<double>(map.magnitude_kPa.values[v]));
    if (!map.storage_kPa) continue;
    storage += static_cast<double>(map.storage_kPa->values[v]);
    loss += static_cast<double>(map.loss_kPa->values[v]);
  }
  if (magnitude.empty()) {
    return failure(Error{"waves-nothing-confident",
                         GLISSON_TEXT("Not one voxel could be inverted with confidence: there is no wave in these "
                                      "images, or it drowns in noise."),
                         {},
                         GLISSON_TEXT("Check that the phase series and the frequency are the right ones."),
                         {}});
  }
  const auto count = static_cast<double>(magnitude.size());
  map.confident_fraction = count / static_cast<double>(region);
  map.mean_storage_kPa = storage / count;
  map.mean_loss_kPa = loss / count;
  map.confident = statistics_of(std::move(magnitude)).value();
  map.mean_kPa = map.confident.mean;
  return {};
}

}  // namespace
}  // namespace glisson::elastography
