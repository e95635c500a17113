#pragma once
// A case that holds raw elastography and nothing else: crossing waves of known stiffness, as an importer leaves them.

#include <filesystem>
#include <QtGlobal>

#include "casefile/case.h"
#include "elastography/wave_phantom.h"
#include "imaging/volume_file.h"

namespace glisson::widgets::test {

// 4 kPa, shaken at 60 Hz: a wavelength of 33 mm in 96 mm.
inline void write_wave_case(const std::filesystem::path& folder) {
  glisson::elastography::WavePhantom phantom;
  phantom.grid = glisson::elastography::cube_grid(48, 5, 2, 4);
  phantom.background_kPa = {4, 0.3};
  const auto images =
      glisson::elastography::measured(phantom, glisson::elastography::crossing_waves(phantom), 1.0, 0.02);
  auto patient = casefile::Case::create(folder);
  if (!patient) qFatal("%s", patient.error().message().c_str());
  int number = 0;
  for (std::size_t direction = 0; direction < images.phase_rad.size(); ++direction) {
    for (std::size_t offset = 0; offset < images.phase_rad[direction].size(); ++offset) {
      const casefile::Provenance made{
          "import",
          {{"frequency_Hz", "60"}, {"direction", std::to_string(direction)}, {"offset", std::to_string(offset)}},
          {},
          {},
          {}};
      const imaging::Volume volume{{images.grid, images.phase_rad[direction][offset]}, "rad"};
      const auto added = patient->add("volumes/phase-" + std::to_string(++number), ".nrrd", made,
                                      [&](const auto& file) { return imaging::write_volume_file(file, volume); });
      if (!added) qFatal("%s", added.error().message().c_str());
    }
  }
}

}  // namespace glisson::widgets::test
