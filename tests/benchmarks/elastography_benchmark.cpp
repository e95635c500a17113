// How long a study of the usual size takes from its phase images to the modulus: 108 x 110 x 5 voxels, three
// directions, eight instants.

#include <benchmark/benchmark.h>

#include "elastography/inversion.h"
#include "elastography/wave_phantom.h"
#include "elastography/waves.h"

namespace glisson::elastography {
namespace {

WaveImages usual_study() {
  WavePhantom phantom;
  phantom.grid = cube_grid(110, 5, 2, 4);
  phantom.grid.size[1] = 108;
  phantom.frequency_Hz = 40;
  phantom.inclusion_kPa = {6, 0.6};
  phantom.radius_mm = 20;
  return measured(phantom, crossing_waves(phantom), 3, 0.1);
}

void inverting(benchmark::State& state, InversionMethod method) {
  const WaveImages images = usual_study();
  InversionOptions options;
  options.method = method;
  for (auto run : state) {
    auto map = invert({images}, {}, options);
    if (!map) state.SkipWithError(map.error().message().c_str());
    benchmark::DoNotOptimize(map);
  }
}

void unwrapping(benchmark::State& state, Unwrapping method) {
  const WaveImages images = usual_study();
  const imaging::Mask tissue = tissue_of(images);
  for (auto run : state) benchmark::DoNotOptimize(unwrap(images.phase_rad[0], tissue, method));
}

BENCHMARK_CAPTURE(inverting, direct, InversionMethod::direct)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(inverting, lfe, InversionMethod::local_frequency)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(unwrapping, laplacian, Unwrapping::laplacian)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(unwrapping, quality_guided, Unwrapping::quality_guided)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace glisson::elastography

BENCHMARK_MAIN();
