#include "closedloop/waves/internal/wave_state.h"

#include <cmath>
#include <numbers>

namespace glisson::closedloop {

using std::numbers::pi;

double mean_frequency(const Elastography& waves) {
  double sum = 0;
  for (const WaveTrial& trial : waves.trials) sum += trial.frequency_Hz;
  return sum / static_cast<double>(waves.trials.size());
}

namespace {

// The imaginary unit, w / w0, and what a spring, a dashpot or something between makes of it.
std::complex<double> springpot(double relative_frequency, double exponent) {
  return std::polar(std::pow(relative_frequency, exponent), exponent * pi / 2);
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

}  // namespace glisson::closedloop
