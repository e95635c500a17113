#include "closedloop/waves/internal/wave_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/result.h"

namespace glisson::closedloop {
namespace {

using std::numbers::pi;

Eigen::VectorXd numbers_of(std::initializer_list<double> values) {
  return Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size()));
}

// The imaginary unit, w / w0, and what a spring, a dashpot or something between makes of it.
std::complex<double> springpot(double relative_frequency, double exponent) {
  return std::polar(std::pow(relative_frequency, exponent), exponent * pi / 2);
}

double mean_frequency(const Elastography& waves) {
  double sum = 0;
  for (const WaveTrial& trial : waves.trials) sum += trial.frequency_Hz;
  return sum / static_cast<double>(waves.trials.size());
}

double reference_of(const Elastography& waves) {
  return waves.declared.reference_Hz > 0 ? waves.declared.reference_Hz : mean_frequency(waves);
}

std::complex<double> shear_modulus(const Elastography& waves, const WaveState& state, double frequency_Hz) {
  const DeclaredWaves& declared = waves.declared;
  const double omega = 2 * pi * frequency_Hz;
  const std::complex<double> i(0, 1);
  const double relative = frequency_Hz / reference_of(waves);
  if (!state.viscosity) {
    switch (declared.law) {
      case WaveLaw::kelvin_voigt: return declared.shear_modulus_kPa + i * omega * declared.viscosity_kPa_s;
      case WaveLaw::springpot: return declared.shear_modulus_kPa * springpot(relative, declared.exponent);
      case WaveLaw::elastic: break;
    }
    return declared.shear_modulus_kPa;
  }
  const auto& [kind, form, numbers] = *state.viscosity;
  if (form == "kelvin-voigt") return declared.shear_modulus_kPa + i * omega * 1e-3 * numbers[0];
  if (form == "structural") return declared.shear_modulus_kPa * (1.0 + i * numbers[0]);
  return declared.shear_modulus_kPa * numbers[0] * springpot(relative, numbers[1]);
}

}  // namespace

WaveState state_of(const Settings& settings) {
  WaveState state;
  for (const Setting& setting : settings) {
    const Eigen::VectorXd& p = setting.parameters;
    if (setting.kind == "stiffness-scale") state.factor *= p[0];
    if (setting.kind == "viscosity") state.viscosity = setting;
    if (setting.kind == "compression-waves") {
      for (const auto& [form, degree] : long_wave_forms)
        if (setting.form == form) state.long_wave_degree = degree;
      state.long_wave_share = p[0];
    }
    if (setting.kind == "stiff-inclusion") state.sphere = {p.head<3>(), p[3], p[4]};
    if (setting.kind == "boundary-layer") state.layer = {p[0], p[1]};
    if (setting.kind == "anisotropy") {
      const double azimuth = p[0] * pi / 180, elevation = p[1] * pi / 180;
      state.axis = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                    std::sin(elevation)};
      state.ratio = p[2];
    }
    if (setting.kind == "slice-timing") {
      state.interleaved = setting.form == "interleaved";
      state.delay_s = 1e-3 * p[0];
    }
  }
  return state;
}

Medium medium_of(const Elastography& waves, const WaveState& state, double frequency_Hz) {
  Medium medium;
  medium.shear_kPa = state.factor * shear_modulus(waves, state, frequency_Hz);
  medium.inertia = waves.declared.density_kg_mm3 * std::pow(2 * pi * frequency_Hz, 2);
  medium.axis = waves.grid.direction.transpose() * state.axis;
  medium.ratio = state.ratio;
  return medium;
}

// Slices follow each other, or the even ones come first.
std::vector<double> slice_phase(const WaveState& state, double frequency_Hz, int slices) {
  if (state.delay_s == 0) return {};
  std::vector<double> phase;
  for (int k = 0; k < slices; ++k) {
    const int turn = !state.interleaved ? k : k % 2 == 0 ? k / 2 : (slices + 1) / 2 + k / 2;
    phase.push_back(2 * pi * frequency_Hz * state.delay_s * turn);
  }
  return phase;
}

std::vector<Effect> wave_effects(const Elastography& waves, double typical_radius_mm, const Eigen::Vector3d& low_mm,
                                 const Eigen::Vector3d& high_mm) {
  const auto components = waves.components.size();
  const double modulus = waves.declared.shear_modulus_kPa;
  const double omega = 2 * pi * mean_frequency(waves);
  std::vector<Effect> effects;

  Effect stiffness{"stiffness-scale",
                   "",
                   {{"factor", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}},
                   GLISSON_TEXT("Shear waves run slower or faster than declared, everywhere and at every frequency."),
                   {}};
  for (const double factor : {0.4, 0.6, 0.8, 0.95, 1.05, 1.25, 1.6, 2.5})
    stiffness.starts.push_back(numbers_of({factor}));
  effects.push_back(std::move(stiffness));

  const char* viscous = GLISSON_TEXT("Waves lose energy on their way, as in a viscous tissue.");
  Effect kelvin_voigt{"viscosity", "kelvin-voigt", {}, viscous, {}};
  const double per_ratio = 1e3 * modulus / omega;  // Pa s that make loss as large as storage
  const bool viscous_already = waves.declared.law == WaveLaw::kelvin_voigt;
  kelvin_voigt.parameters = {{"viscosity_Pa_s", viscous_already ? 1e3 * waves.declared.viscosity_kPa_s : 0, 0,
                              10 * per_ratio, 0, per_ratio, Scale::linear}};
  Effect structural{"viscosity", "structural", {{"loss_ratio", 0, 0, 5, 0, 1, Scale::linear}}, viscous, {}};
  for (const double loss : {0.05, 0.15, 0.4, 0.8}) {
    kelvin_voigt.starts.push_back(numbers_of({loss * per_ratio}));
    structural.starts.push_back(numbers_of({loss}));
  }
  Effect springpot_form{"viscosity",
                        "springpot",
                        {{"factor", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}, {"exponent", 0, 0, 1, 0, 0.5}},
                        viscous,
                        {}};
  for (const double factor : {0.7, 1.0, 1.4})
    for (const double exponent : {0.05, 0.2, 0.4}) springpot_form.starts.push_back(numbers_of({factor, exponent}));
  for (Effect* form : {&kelvin_voigt, &structural, &springpot_form}) effects.push_back(std::move(*form));

  if (components >= 2) {
    Effect grain{"anisotropy",
                 "",
                 {{"azimuth_deg", 0, -180, 540, 0, 180},
                  {"elevation_deg", 0, -110, 110, -60, 60},
                  {"ratio", 1, 0.1, 10, 0.5, 2, Scale::logarithmic}},
                 GLISSON_TEXT("Shear waves along one direction, as of fibres, run at another speed than across it."),
                 {}};
    // Evenly over half of all directions: an axis has no sense.
    for (const auto& [elevation, step, most] :
         {std::array{0, 45, 180}, std::array{35, 45, 360}, std::array{70, 90, 360}})
      for (int azimuth = 0; azimuth < most; azimuth += step)
        for (const double ratio : {0.7, 1.5})
          grain.starts.push_back(numbers_of({static_cast<double>(azimuth), static_cast<double>(elevation), ratio}));
    effects.push_back(std::move(grain));
  }

  if (components == 3 && waves.grid.size[2] > 1 && !waves.declared.pressure_is_free) {
    for (const auto& [form, degree] : long_wave_forms)
      effects.push_back(
          {"compression-waves",
           form,
           {{"share", 0, 0, 2, 0.5, 1.5, Scale::linear}},
           GLISSON_TEXT("Besides shear waves there are long ones that compress; the declared equation knows none."),
           {numbers_of({1})},
           degree > 2});
  }

  if (waves.grid.size[2] > 1) {
    for (const char* form : {"sequential", "interleaved"}) {
      double highest = 0;
      for (const WaveTrial& trial : waves.trials) highest = std::max(highest, trial.frequency_Hz);
      // Between neighbours at most an eighth of a turn of the fastest wave, of interleaved slices, of which half of all
      // come later, a quarter: turned further, waves of any law would leave the band that the bumps see.
      const bool sequential = std::string_view(form) == "sequential";
      const double turn_ms = 1000 / highest;
      const double most_ms = sequential ? turn_ms / 8 : turn_ms / 4 / ((waves.grid.size[2] + 1) / 2);
      Effect timing{"slice-timing",
                    form,
                    {{"delay_ms", 0, -most_ms, most_ms, -0.3 * most_ms, 0.3 * most_ms}},
                    GLISSON_TEXT("Slices were not measured at one moment of the vibration, but one after the other."),
                    {}};
      for (int step = -6; step <= 6; ++step)
        if (step != 0) timing.starts.push_back(numbers_of({most_ms * step / 7.0}));
      effects.push_back(std::move(timing));
    }
  }

  Effect inclusion{"stiff-inclusion", "", {}, GLISSON_TEXT("A region inside is stiffer or softer than declared."), {}};
  for (int axis = 0; axis < 3; ++axis)
    inclusion.parameters.push_back(
        {"center_mm", (low_mm[axis] + high_mm[axis]) / 2, low_mm[axis], high_mm[axis], low_mm[axis], high_mm[axis]});
  const double half = (high_mm - low_mm).maxCoeff() / 2;
  inclusion.parameters.push_back({"radius_mm", typical_radius_mm, std::min(0.2 * typical_radius_mm, 0.4 * half), half,
                                  std::min(0.3 * typical_radius_mm, 0.5 * half), 0.8 * half, Scale::logarithmic});
  inclusion.parameters.push_back({"ratio", 1, 0.05, 20, 0.4, 4, Scale::logarithmic});
  effects.push_back(std::move(inclusion));

  Effect layer{"boundary-layer",
               "",
               {{"depth_mm", typical_radius_mm, 0.3 * typical_radius_mm, half, 0.5 * typical_radius_mm, 0.7 * half,
                 Scale::logarithmic},
                {"ratio", 1, 0.05, 20, 0.4, 4, Scale::logarithmic}},
               GLISSON_TEXT("Along the border another stiffness holds than inside."),
               {}};
  for (const double depth : {0.7, 1.0, 1.5, 2.0})
    for (const double ratio : {0.6, 0.85, 1.2, 1.7})
      layer.starts.push_back(numbers_of({std::min(depth * typical_radius_mm, half), ratio}));
  effects.push_back(std::move(layer));
  return effects;
}

}  // namespace glisson::closedloop
