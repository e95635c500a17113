#include "elastography/unwrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/parallel.h"
#include "base/result.h"
#include "elastography/internal/unwrap_in_space.h"

namespace glisson::elastography {
namespace {

constexpr float turn = static_cast<float>(2 * std::numbers::pi);

// The value that most voxels of the mask have, of those from begin to end.
int most_common(const std::vector<int>& values, const imaging::Mask& mask, std::size_t begin, std::size_t end) {
  std::map<int, std::size_t> count;
  for (std::size_t v = begin; v < end; ++v) {
    if (mask.values[v] != 0) ++count[values[v]];
  }
  const auto maximum =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return maximum == count.end() ? 0 : maximum->first;
}

}  // namespace

float wrapped(float phase_rad) { return phase_rad - turn * std::round(phase_rad / turn); }

UnwrappedPhase unwrap(const std::vector<std::vector<float>>& wrapped_rad, const imaging::Mask& signal,
                      Unwrapping method) {
  const std::size_t instants = wrapped_rad.size();
  const std::size_t voxels = signal.grid.voxels();
  GLISSON_ASSERT(instants >= 3);
  std::vector<std::vector<float>> difference(instants, std::vector<float>(voxels));
  parallel_for(instants, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const std::vector<float>& now = wrapped_rad[t];
      const std::vector<float>& next = wrapped_rad[(t + 1) % instants];
      for (std::size_t v = 0; v < voxels; ++v) difference[t][v] = wrapped(next[v] - now[v]);
      if (method == Unwrapping::laplacian) unwrap_by_poisson(difference[t], signal);
      if (method == Unwrapping::quality_guided) unwrap_along_reliable_paths(difference[t], signal);
    }
  });

  UnwrappedPhase unwrapped;
  unwrapped.phase_rad.assign(instants, std::vector<float>(voxels));
  std::vector<int> turns(voxels);
  for (std::size_t v = 0; v < voxels; ++v) {
    float sum = 0;
    float mean = 0;
    for (std::size_t t = 0; t < instants; ++t) {
      unwrapped.phase_rad[t][v] = sum;
      mean += sum;
      sum += difference[t][v];
    }
    mean /= static_cast<float>(instants);
    for (std::size_t t = 0; t < instants; ++t) unwrapped.phase_rad[t][v] -= mean;
    turns[v] = static_cast<int>(std::lround(sum / turn));
  }
  // The scanner's phase may drift through whole turns of its own, which all voxels of a slice share.
  const std::size_t slice = voxels / static_cast<std::size_t>(signal.grid.size[2]);
  for (std::size_t begin = 0; begin < voxels; begin += slice) {
    const int shared = most_common(turns, signal, begin, begin + slice);
    for (std::size_t v = begin; v < begin + slice; ++v) unwrapped.closed.push_back(turns[v] == shared ? 1 : 0);
  }
  return unwrapped;
}

}  // namespace glisson::elastography
