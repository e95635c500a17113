#pragma once
// Shear waves whose medium is known, in closed form, and what a scanner makes of them: truth to judge inversions by.
//
// The field solves div(G grad u) + density w^2 u = 0 with complex G that jumps where two media meet. There u and G
// du/dn are continuous. Around one sphere it is a series of spherical Bessel functions times Legendre polynomials (the
// acoustic analogue: Anderson, J. Acoust. Soc. Am. 22:426, 1950). At a plane it is a wave, its reflection and what goes
// through. Nothing of it is discretised, and nothing of it is shared with the inversions. Media go on without end:
// no wave comes back from a body's surface. Time runs as e^(i w t). Density is that of water.

#include <complex>
#include <vector>

#include "elastography/wave_images.h"
#include "elastography/waves.h"

namespace glisson::elastography {

using Complex = std::complex<double>;

struct WavePhantom {
  imaging::Grid grid;
  double frequency_Hz = 60;
  Complex background_kPa{3, 0.5};
  Complex inclusion_kPa{3, 0.5};
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;  // 0: no inclusion

  [[nodiscard]] bool in_inclusion(const Eigen::Vector3d& at_mm) const { return (at_mm - center_mm).norm() < radius_mm; }
  [[nodiscard]] Complex modulus_kPa(const Eigen::Vector3d& at_mm) const {
    return in_inclusion(at_mm) ? inclusion_kPa : background_kPa;
  }
};

// Two media that meet at a plane across z.
struct LayeredPhantom {
  imaging::Grid grid;
  double frequency_Hz = 60;
  Complex lower_kPa{3, 0.5}, upper_kPa{3, 0.5};
  double plane_z_mm = 0;
};

// Wavenumber in 1/mm, damped in the direction in which the wave runs.
[[nodiscard]] Complex wavenumber(double frequency_Hz, Complex modulus_kPa);
[[nodiscard]] double wavelength_mm(double frequency_Hz, Complex modulus_kPa);

// A cube of voxels about the origin; slices `slice_mm` apart.
[[nodiscard]] imaging::Grid cube_grid(int across, int slices, double voxel_mm, double slice_mm);

// The wave that comes in along `direction` (unit length) with amplitude 1 at the inclusion's centre.
[[nodiscard]] ComplexField scattered_wave(const WavePhantom& phantom, const Eigen::Vector3d& direction);

// The wave that comes in along `direction` (unit length, not along the plane) from its side, with amplitude 1 at the
// plane over the origin.
[[nodiscard]] ComplexField refracted_wave(const LayeredPhantom& phantom, const Eigen::Vector3d& direction);

// Motion along three directions: in each two waves that cross, one of them half as strong.
[[nodiscard]] std::vector<ComplexField> crossing_waves(const WavePhantom& phantom);
// The same, each of the two from another side of the plane, at 30 to 60 degrees from upright.
[[nodiscard]] std::vector<ComplexField> crossing_waves(const LayeredPhantom& phantom);

// What a scanner makes of motion along x, y and z: at `instants` of a period the phase, amplitude_rad where a component
// is strongest, over a still phase that wraps several times across the image, with Gaussian noise, and all of it modulo
// one turn.
[[nodiscard]] WaveImages measured(const imaging::Grid& grid, double frequency_Hz,
                                  const std::vector<ComplexField>& components, double amplitude_rad, double noise_rad,
                                  int instants = 8, unsigned seed = 1);
[[nodiscard]] WaveImages measured(const WavePhantom& phantom, const std::vector<ComplexField>& components,
                                  double amplitude_rad, double noise_rad, int instants = 8, unsigned seed = 1);

}  // namespace glisson::elastography
