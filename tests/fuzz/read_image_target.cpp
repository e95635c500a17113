// The bytes stand in memory under a path, so that the reader meets them as a file and no disc is worn.

#include "fuzz/read_image_target.h"

#include <sys/mman.h>
#include <unistd.h>
#include <cmath>
#include <cstdlib>
#include <string>

#include "imaging/read_series.h"

namespace {

// What a reader may promise about any input: numbers, no more of them than the grid has, in a place that exists.
void check(const glisson::imaging::Series& series, const glisson::imaging::Volume& volume) {
  const bool sound = volume.values.size() == series.grid.voxels() && series.grid.direction.allFinite() &&
                     series.grid.origin_mm.allFinite() && (series.grid.spacing_mm.array() > 0).all();
  if (!sound) std::abort();
  for (const float value : volume.values) {
    if (std::isnan(value)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = ::memfd_create("glisson-fuzz", MFD_CLOEXEC);
  if (file < 0) return 0;
  if (::write(file, data, size) == static_cast<::ssize_t>(size)) {
    const auto study = glisson::imaging::scan("/proc/self/fd/" + std::to_string(file));
    if (study) {
      for (const auto& series : study->series) {
        // A header may ask for far more voxels than it has bytes (compressed); more than these only take time.
        if (series.grid.voxels() > (std::size_t{1} << 22)) continue;
        for (int volume = 0; volume < std::min(series.volumes, 4); ++volume) {
          if (const auto values = glisson::imaging::read_series(series, volume)) check(series, *values);
        }
      }
    }
  }
  ::close(file);
  return 0;
}
