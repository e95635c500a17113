#include "closedloop/waves/internal/wave_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "closedloop/waves/internal/wave_state.h"

namespace glisson::closedloop {
namespace {

Effect shear_stiffness();
std::vector<Effect> viscosities(const Elastography& waves);
Effect anisotropy();
std::vector<Effect> compression_waves();
std::vector<Effect> slice_timings(const Elastography& waves);
Effect stiff_inclusion(double patch_mm, const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm);
std::vector<Effect> boundary_layers(double patch_mm, double half_mm);

}  // namespace

std::vector<Effect> wave_effects(const Elastography& waves, double typical_radius_mm, const Eigen::Vector3d& low_mm,
                                 const Eigen::Vector3d& high_mm) {
  std::vector<Effect> effects{shear_stiffness()};
  const auto add = [&](std::vector<Effect> more) {
    for (Effect& effect : more) effects.push_back(std::move(effect));
  };
  const bool has_slices = waves.grid.size[2] > 1;
  add(viscosities(waves));
  if (waves.components.size() >= 2) add({anisotropy()});
  if (waves.components.size() == 3 && has_slices && !waves.declared.pressure_is_free) add(compression_waves());
  if (has_slices) add(slice_timings(waves));
  add({stiff_inclusion(typical_radius_mm, low_mm, high_mm)});
  add(boundary_layers(typical_radius_mm, (high_mm - low_mm).maxCoeff() / 2));
  return effects;
}

namespace {

Effect shear_stiffness() {
  Effect effect{"stiffness-scale",
                "",
                {{"factor", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}},
                GLISSON_TEXT("Shear waves run slower or faster than declared, everywhere and at every frequency."),
                {}};
  for (const double factor : {0.4, 0.6, 0.8, 0.95, 1.05, 1.25, 1.6, 2.5}) effect.starts.push_back(numbers_of({factor}));
  return effect;
}

std::vector<Effect> viscosities(const Elastography& waves) {
  const char* sentence = GLISSON_TEXT("Waves lose energy on their way, as in a viscous tissue.");
  // Pa s that make the loss modulus as large as the storage modulus.
  const double per_ratio = 1e3 * waves.declared.shear_modulus_kPa / (2 * std::numbers::pi * mean_frequency(waves));
  const bool declared = waves.declared.law == WaveLaw::kelvin_voigt;
  Effect kelvin_voigt{"viscosity",
                      "kelvin-voigt",
                      {{"viscosity_Pa_s", declared ? 1e3 * waves.declared.viscosity_kPa_s : 0, 0, 10 * per_ratio, 0,
                        per_ratio, Scale::linear}},
                      sentence,
                      {}};
  Effect structural{"viscosity", "structural", {{"loss_ratio", 0, 0, 5, 0, 1, Scale::linear}}, sentence, {}};
  for (const double loss : {0.05, 0.15, 0.4, 0.8}) {
    kelvin_voigt.starts.push_back(numbers_of({loss * per_ratio}));
    structural.starts.push_back(numbers_of({loss}));
  }
  Effect springpot{"viscosity",
                   "springpot",
                   {{"factor", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}, {"exponent", 0, 0, 1, 0, 0.5}},
                   sentence,
                   {}};
  for (const double factor : {0.7, 1.0, 1.4})
    for (const double exponent : {0.05, 0.2, 0.4}) springpot.starts.push_back(numbers_of({factor, exponent}));
  return {std::move(kelvin_voigt), std::move(structural), std::move(springpot)};
}

// Searched evenly over half of all directions: an axis has no sense.
Effect anisotropy() {
  Effect effect{"anisotropy",
                "",
                {{"azimuth_deg", 0, -180, 540, 0, 180},
                 {"elevation_deg", 0, -110, 110, -60, 60},
                 {"ratio", 1, 0.1, 10, 0.5, 2, Scale::logarithmic}},
                GLISSON_TEXT("Shear waves along one direction, as of fibres, run at another speed than across it."),
                {}};
  for (const auto& [elevation, step, end] : {std::array{0, 45, 180}, std::array{35, 45, 360}, std::array{70, 90, 360}})
    for (int azimuth = 0; azimuth < end; azimuth += step)
      for (const double ratio : {0.7, 1.5})
        effect.starts.push_back(numbers_of({static_cast<double>(azimuth), static_cast<double>(elevation), ratio}));
  return effect;
}

std::vector<Effect> compression_waves() {
  std::vector<Effect> effects;
  for (const auto& [form, degree] : long_wave_forms)
    effects.push_back(
        {"compression-waves",
         form,
         {{"share", 0, 0, 2, 0.5, 1.5, Scale::linear}},
         GLISSON_TEXT("Besides shear waves there are long ones that compress; the declared equation knows none."),
         {numbers_of({1})},
         degree > 2});
  return effects;
}

// Between neighbours at most an eighth of a turn of the fastest wave. Of interleaved slices half of all come later: a
// quarter. Turned further, waves of any law would leave the band that the bumps see.
std::vector<Effect> slice_timings(const Elastography& waves) {
  double highest_Hz = 0;
  for (const WaveTrial& trial : waves.trials) highest_Hz = std::max(highest_Hz, trial.frequency_Hz);
  const double turn_ms = 1000 / highest_Hz;
  const int in_first_pass = (waves.grid.size[2] + 1) / 2;  // slices, where they are interleaved
  std::vector<Effect> effects;
  for (const char* form : {"sequential", "interleaved"}) {
    const bool sequential = std::string_view(form) == "sequential";
    const double most_ms = sequential ? turn_ms / 8 : turn_ms / 4 / in_first_pass;
    Effect effect{"slice-timing",
                  form,
                  {{"delay_ms", 0, -most_ms, most_ms, -0.3 * most_ms, 0.3 * most_ms}},
                  GLISSON_TEXT("Slices were not measured at one moment of the vibration, but one after the other."),
                  {}};
    for (int step = -6; step <= 6; ++step)
      if (step != 0) effect.starts.push_back(numbers_of({most_ms * step / 7.0}));
    effects.push_back(std::move(effect));
  }
  return effects;
}

// Its search begins where the model looks (waves/model.cpp).
Effect stiff_inclusion(double patch_mm, const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm) {
  Effect effect{"stiff-inclusion", "", {}, GLISSON_TEXT("A region inside is stiffer or softer than declared."), {}};
  for (int axis = 0; axis < 3; ++axis)
    effect.parameters.push_back(
        {"center_mm", (low_mm[axis] + high_mm[axis]) / 2, low_mm[axis], high_mm[axis], low_mm[axis], high_mm[axis]});
  const double half_mm = (high_mm - low_mm).maxCoeff() / 2;
  effect.parameters.push_back({"radius_mm", std::min(patch_mm, 0.8 * half_mm), std::min(0.2 * patch_mm, 0.4 * half_mm),
                               half_mm, std::min(0.3 * patch_mm, 0.5 * half_mm), 0.8 * half_mm, Scale::logarithmic});
  effect.parameters.push_back({"ratio", 1, 0.05, 20, 0.4, 4, Scale::logarithmic});
  return effect;
}

// None where the region is no wider than a patch: its depths could not be told apart.
std::vector<Effect> boundary_layers(double patch_mm, double half_mm) {
  const double thinnest_expected_mm = 0.5 * patch_mm, thickest_expected_mm = 0.7 * half_mm;
  if (thickest_expected_mm < 1.5 * thinnest_expected_mm) return {};
  Effect effect{
      "boundary-layer",
      "",
      {{"depth_mm", patch_mm, 0.3 * patch_mm, half_mm, thinnest_expected_mm, thickest_expected_mm, Scale::logarithmic},
       {"ratio", 1, 0.05, 20, 0.4, 4, Scale::logarithmic}},
      GLISSON_TEXT("Along the border another stiffness holds than inside."),
      {}};
  for (const double depth : {0.7, 1.0, 1.5, 2.0})
    for (const double ratio : {0.6, 0.85, 1.2, 1.7})
      effect.starts.push_back(numbers_of({std::min(depth * patch_mm, half_mm), ratio}));
  return {std::move(effect)};
}

}  // namespace
}  // namespace glisson::closedloop
