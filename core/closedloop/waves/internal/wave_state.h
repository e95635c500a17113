#pragma once
// Which effects are on, with their numbers, as what they change of the declared law.

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

// Effects that the experiment could show. `typical_radius_mm` is that of its patches, which lie between low and high.
[[nodiscard]] std::vector<Effect> wave_effects(const Elastography& waves, double typical_radius_mm,
                                               const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm);

}  // namespace glisson::closedloop
