// How stiff is tissue through which this wave runs?
//
// Makes the phase images of a plane shear wave of 60 Hz in tissue of 3 kPa, wrapped as a scanner gives them, and
// inverts them: the wavelength is sqrt(3 kPa / 1000 kg/m3) / 60 Hz = 28.9 mm.

#include <cmath>
#include <numbers>

#include "elastography/inversion.h"
#include "or_stop.h"

using namespace glisson;

elastography::WaveImages plane_wave(double wavelength_mm, double amplitude_rad) {
  elastography::WaveImages images;
  images.frequency_Hz = 60;
  images.grid.size = {48, 48, 12};
  images.grid.spacing_mm = {2, 2, 2};
  images.along = {Eigen::Vector3d::UnitZ()};  // the wave moves tissue along z and runs along x
  images.phase_rad.resize(1);
  constexpr int instants = 8;
  for (int t = 0; t < instants; ++t) {
    std::vector<float> phase(images.grid.voxels());
    for (int k = 0; k < 12; ++k)
      for (int j = 0; j < 48; ++j)
        for (int i = 0; i < 48; ++i) {
          const double turns = images.grid.position_mm(i, j, k).x() / wavelength_mm - double(t) / instants;
          const double moved = amplitude_rad * std::cos(2 * std::numbers::pi * turns);
          phase[images.grid.offset(i, j, k)] = elastography::wrapped(static_cast<float>(moved));
        }
    images.phase_rad[0].push_back(std::move(phase));
  }
  return images;
}

int main() {
  const double wavelength_mm = 1000 * std::sqrt(3e3 / 1000) / 60;
  const auto map = or_stop(elastography::invert({plane_wave(wavelength_mm, 2.0)}));
  fmt::print("{:.2f} kPa over the {:.0f} % of the voxels that are to be believed; the truth is 3 kPa.\n", map.mean_kPa,
             100 * map.confident_fraction);
}
