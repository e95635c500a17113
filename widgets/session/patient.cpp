#include "session/patient.h"

#include <algorithm>

namespace glisson::widgets {

GreyWindow usual_window(const imaging::Volume& volume) {
  // A few ten thousand samples tell as much as all voxels do.
  const std::size_t stride = std::max<std::size_t>(1, volume.values.size() / 40000);
  std::vector<float> samples;
  for (std::size_t k = 0; k < volume.values.size(); k += stride) samples.push_back(volume.values[k]);
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const double low = samples[samples.size() / 100];
  const double high = samples[samples.size() - 1 - samples.size() / 100];
  return {0.5 * (low + high), std::max(high - low, 1e-3)};
}

}  // namespace glisson::widgets
