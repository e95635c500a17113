#include "widgets/views/grey_window.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glisson::widgets {

const std::array<GreyWindow, 4>& ct_windows() {
  static constexpr std::array<GreyWindow, 4> windows{{{40, 400}, {60, 160}, {-600, 1500}, {400, 1800}}};
  return windows;
}

GreyWindow automatic_window(const imaging::Volume& volume) {
  // A few ten thousand samples tell as much as all voxels do.
  const std::size_t stride = std::max<std::size_t>(1, volume.values.size() / 40000);
  std::vector<float> samples;
  for (std::size_t k = 0; k < volume.values.size(); k += stride) samples.push_back(volume.values[k]);
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const double low = samples[samples.size() / 100];
  const double high = samples[samples.size() - 1 - samples.size() / 100];
  return {0.5 * (low + high), std::max(high - low, 1e-3)};
}

bool in_hounsfield_units(const imaging::Volume& volume) {
  if (!volume.unit.empty()) return volume.unit == "HU";  // a unit, not translated
  constexpr std::size_t maximum_samples = 4000;
  const std::size_t stride = std::max<std::size_t>(1, volume.values.size() / maximum_samples);
  std::size_t samples = 0, air = 0, tissue = 0;
  for (std::size_t k = 0; k < volume.values.size(); k += stride, ++samples) {
    const float value = volume.values[k];
    if (value >= -1100 && value <= -800) ++air;
    if (value >= -150 && value <= 250) ++tissue;
  }
  return 50 * air > samples && 10 * tissue > samples;
}

GreyWindow first_window(const imaging::Volume& volume) {
  return *window_of(in_hounsfield_units(volume) ? WindowPreset::liver : WindowPreset::automatic, volume);
}

WindowPreset preset_of(const GreyWindow& window, const imaging::Volume& volume) {
  constexpr double same_share = 0.005;  // of the width: less than can be seen
  for (const auto preset :
       {WindowPreset::liver, WindowPreset::abdomen, WindowPreset::lung, WindowPreset::bone, WindowPreset::automatic}) {
    const auto known = window_of(preset, volume);
    if (!known) continue;
    const double maximum = same_share * known->width;
    if (std::abs(known->center - window.center) < maximum && std::abs(known->width - window.width) < maximum)
      return preset;
  }
  return WindowPreset::own;
}

std::optional<GreyWindow> window_of(WindowPreset preset, const imaging::Volume& volume) {
  if (preset == WindowPreset::own) return std::nullopt;
  if (preset == WindowPreset::automatic) return automatic_window(volume);
  if (!in_hounsfield_units(volume)) return std::nullopt;
  return ct_windows()[static_cast<std::size_t>(preset) - static_cast<std::size_t>(WindowPreset::abdomen)];
}

}  // namespace glisson::widgets
