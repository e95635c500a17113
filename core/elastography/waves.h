#pragma once
// The wave that a scan measured: at each voxel the complex amplitude of the motion at the frequency of the vibration.
// With e^(i w t) for time, phase(t) = Re(u e^(i w t)). The unit stays rad of encoded phase, since nothing here depends
// on how many um that is.

#include <complex>
#include <vector>

#include "elastography/unwrap.h"
#include "elastography/wave_images.h"

namespace glisson::elastography {

using ComplexField = std::vector<std::complex<float>>;  // one value a voxel

struct Waves {
  double frequency_Hz = 0;
  imaging::Grid grid;
  std::vector<ComplexField> components;  // of the displacement along each direction, or of its curl
  // Standard deviation of the real and of the imaginary part of a component, one a voxel. It comes from what the
  // measured instants hold besides their mean and their first harmonic.
  std::vector<float> noise_rad;
  imaging::Mask signal;        // where tissue gave a signal and the phase unwrapped without contradiction
  double closed_fraction = 1;  // of the tissue's voxels: those that did
};

// Voxels where tissue gave a signal. There the magnitude is above the threshold that parts it best in two (Otsu, IEEE
// Transactions on Systems, Man, and Cybernetics 9:62, 1979). Everything where no magnitude is known.
[[nodiscard]] imaging::Mask tissue_of(const WaveImages& images);

// The first harmonic over the instants, of the phase unwrapped inside `tissue`. What all of a slice does alike is taken
// off, and all slices are turned to one instant.
[[nodiscard]] Waves first_harmonic(const WaveImages& images, const imaging::Mask& tissue,
                                   Unwrapping unwrapping = Unwrapping::laplacian);

// Compression waves are metres long, and bulk motion is longer still. Either of the two takes them off and leaves the
// shear waves. All derivatives of those obey the same wave equation.
// - A high-pass, less the Gaussian average over the tissue around, in each slice by itself. It takes off too what a
//   slice has alone. With sd_mm of half a wavelength a plane wave keeps 99 % of its amplitude and loses nothing of its
//   wavelength.
// - The curl, which is without compression by its nature. But it amplifies noise and needs the three directions.
[[nodiscard]] Waves without_long_waves(Waves waves, double sd_mm);

// The head or the trunk is rocked as a whole, often by more than the waves in it. In each slice and component the plane
// that fits best is taken off. Near a border the high-pass leaves much of such a slope, so that it comes after this.
[[nodiscard]] Waves without_swaying(Waves waves);

// The curl of a displacement measured along `along` (three independent unit vectors, LPS), by central differences
// inside the signal, one-sided at its border. Fails with waves-no-curl where there are not three directions, or fewer
// than three slices.
Result<Waves> curl_of(const Waves& waves, const std::vector<Eigen::Vector3d>& along);

}  // namespace glisson::elastography
