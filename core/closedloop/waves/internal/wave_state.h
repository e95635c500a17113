#pragma once
// Which effects (wave_effects.h) are on, with their numbers, as what they change of the declared law.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/waves/internal/wave_law.h"

namespace glisson::closedloop {

struct WaveState {
  double factor = 1;
  std::optional<Setting> viscosity;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // patient LPS
  double ratio = 1;
  int long_wave_degree = 0;    // of potentials that are taken off each trial
  double long_wave_share = 0;  // how much of what they take
  struct Sphere {
    Eigen::Vector3d center_mm;  // patient LPS
    double radius_mm = 0, ratio = 1;
  };
  std::optional<Sphere> sphere;
  struct Layer {
    double depth_mm = 0, ratio = 1;
  };
  std::optional<Layer> layer;
  bool interleaved = false;
  double delay_s = 0;

  [[nodiscard]] bool is_isotropic() const { return ratio == 1; }
};

[[nodiscard]] WaveState state_of(const Settings& settings);

// The medium outside of any region.
[[nodiscard]] Medium medium_of(const Elastography& waves, const WaveState& state, double frequency_Hz);

// What turns each slice against the first (rad); empty where nothing does.
[[nodiscard]] std::vector<double> slice_phase(const WaveState& state, double frequency_Hz, int slices);

// Degrees of the potentials of long waves that may be taken off, each a form of its effect.
inline constexpr std::array<std::pair<const char*, int>, 3> long_wave_forms{
    {{"degree-2", 2}, {"degree-4", 4}, {"degree-6", 6}}};

[[nodiscard]] double mean_frequency(const Elastography& waves);  // Hz

}  // namespace glisson::closedloop
