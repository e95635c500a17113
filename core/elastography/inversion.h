#pragma once
// From the phase images of an elastography scan to a map of the shear modulus, with how far each voxel is to be
// believed.
//
//   const auto sorted = sort_waves(std::move(images), {.frequency_Hz = 60});
//   const auto map = invert(sorted->frequencies, liver);

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/sentence.h"
#include "elastography/region_statistics.h"
#include "elastography/unwrap.h"
#include "elastography/wave_images.h"
#include "elastography/waves.h"

namespace glisson::elastography {

enum class InversionMethod {
  direct,          // the complex modulus (internal/helmholtz.h)
  local_frequency  // density times squared wave speed (local_frequency.h): the storage modulus where nothing is lost
};
[[nodiscard]] std::string_view method_name(InversionMethod method);  // "direct", "lfe"

enum class LongWaves {
  high_pass,  // works on any data
  curl,       // where all three directions are known
  keep
};

// Whether the direct inversion sees waves that run in different directions together or each by itself
// (wave_directions.h); local frequency estimation always tells them apart. On known truth (tests/elastography) apart is
// more right where it is confident and confident in an eighth fewer voxels, those at the border.
enum class Directions { together, apart };

struct InversionOptions {
  InversionMethod method = InversionMethod::direct;
  Unwrapping unwrapping = Unwrapping::laplacian;  // the best of the three on known truth (tests/elastography)
  LongWaves long_waves = LongWaves::high_pass;
  Directions directions = Directions::together;

  // Standard deviation of the weights of the local fit in wavelengths, and never below that in voxels. Smaller follows
  // detail, larger suppresses noise; tests/elastography prints the trade.
  double smoothing_wavelengths = 0.10;
  double minimum_smoothing_voxels = 0.8;

  // Derivatives along the normal of the slices need some slices. Below this many each slice is inverted by itself. That
  // makes tissue look stiffer where waves cross the slice obliquely.
  int minimum_slices_of_a_volume = 5;

  double minimum_confidence = 0.5;  // a voxel above it is confident
};

struct ModulusMap {
  InversionMethod method = InversionMethod::direct;
  std::vector<double> frequencies_Hz;
  imaging::Volume magnitude_kPa;               // |G*|; for lfe density times speed squared. 0: nothing is known
  std::optional<imaging::Volume> storage_kPa;  // direct only
  std::optional<imaging::Volume> loss_kPa;
  imaging::Volume confidence;     // 0 to 1
  imaging::Volume amplitude_rad;  // of the wave after long waves were taken off, over all components
  imaging::Volume wave_rad;       // its strongest component at the first instant, at the first frequency; for pictures
  ComplexField moving_wave_rad;   // the same at all instants: the real part of it times e^(i w t)
  imaging::Mask region;           // voxels of the organ (or the tissue) that could be inverted at all
  double typical_wavelength_mm = 0;                // of the first frequency
  RegionStatistics confident;                      // of magnitude_kPa over the confident voxels
  double mean_kPa = 0;                             // confident.mean
  double mean_storage_kPa = 0, mean_loss_kPa = 0;  // over the confident voxels; direct only
  double confident_fraction = 0;                   // of the region's voxels
  std::vector<Sentence> notes;
};

// `organ` may lie on any grid. Only its voxels are inverted, and the direct method uses none from outside it: another
// organ behind the border has another modulus. Without an organ the tissue that gave a signal is inverted.
//
// Fails with waves-none, waves-empty-organ (organ and waves do not overlap), waves-no-curl, waves-nothing-confident
// (there is only noise), or with "cancelled".
Result<ModulusMap> invert(const std::vector<WaveImages>& images, const std::optional<imaging::Mask>& organ = {},
                          const InversionOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::elastography
