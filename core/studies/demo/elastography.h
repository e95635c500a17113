#pragma once
// The demo patient's stiffness, the shear waves that it carries, and the map that a scanner would make of them.
// SIMULATED: true values first, then what measuring does to them.

#include <cstdint>
#include <vector>

#include "imaging/image.h"
#include "studies/demo/anatomy.h"

namespace glisson::studies {

// Shear moduli G in kPa.
struct DemoStiffness {
  // The liver's tissue between the patches: mildly fibrotic. Healthy means are 2.1 and 2.6 (dissertation, section 4.3).
  double liver_kPa = 2.7;
  // Patches of advanced fibrosis; livers reach from 2 to 80 (section 4.1, which does not say of which modulus).
  double fibrotic_kPa = 6.2;
  // Cancer is 5 to 28 times stiffer than what surrounds it (section 1.5, reference 64 there): the low end of that.
  double tumour_ratio = 5.0;
};

// The true shear modulus of every voxel, kPa; 0 where no shear wave runs (air, lung, bone, fluid).
[[nodiscard]] imaging::Volume true_shear_modulus(const TissueImage& tissues, const DemoStiffness& stiffness,
                                                 std::uint64_t seed);

struct WaveOptions {
  double frequency_Hz = 60;  // what liver MRE is done with clinically (QIBA profile of the RSNA)
  double density_kg_m3 = 1000;
  double damping_ratio = 0.12;  // imaginary over twice the real part of the modulus; soft tissue, in the tenths
  double amplitude_um = 40;     // at the driver
  int phase_offsets = 4;        // evenly over one period
  double body_size = 1;         // as DemoAnatomy's: the driver lies on the skin
};

// Displacement along the slices' normal, um, one volume a phase offset. There are several wave fronts: the driver on
// the right front of the chest, and two weaker ones that scatter back. Each is u = A exp(-zeta phi) cos(omega t - phi)
// with the phase phi = omega T. T is the first arrival through the tissue at c = sqrt(G / rho). This is high-frequency
// (WKB) theory, so that the local wavelength is c / f. Within a fraction of a wavelength of abrupt changes the true
// field would bend, and this one does not. T solves |grad T| = 1 / c by fast sweeping (Zhao 2005, Math. Comp. 74, 603).
struct Waves {
  std::vector<imaging::Volume> displacement_um;
  imaging::Volume amplitude_um;
};
[[nodiscard]] Waves simulate_waves(const imaging::Volume& shear_kPa, const WaveOptions& options, std::uint64_t seed);

// First arrival, s, from the voxels of `source` (not 0); infinite where no wave gets to. Exposed for its test.
[[nodiscard]] imaging::Image<double> arrival_time_s(const imaging::Volume& shear_kPa, double density_kg_m3,
                                                    const imaging::Mask& source);

// What the scanner's own inversion would make of it.
struct MeasuredStiffness {
  imaging::Volume shear_kPa;   // blurred over the inversion's window, noisy; far too low within 3 mm of the liver's
                               // border, and unreliable in the first and last slice; 0 outside the body
  imaging::Volume confidence;  // 1 where the waves were strong enough to be trusted, else 0
};
[[nodiscard]] MeasuredStiffness measure_stiffness(const imaging::Volume& true_shear_kPa, const imaging::Mask& liver,
                                                  const imaging::Volume& wave_amplitude_um, std::uint64_t seed);

}  // namespace glisson::studies
