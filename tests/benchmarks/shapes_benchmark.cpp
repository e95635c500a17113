// The liver of a SIMULATED portal-venous CT of 512 x 512 x 300, by brightness and shape together. The time of the
// processor is that of all threads.
//
//   bench_shapes        counter: dice, against the liver that the image was made around

#include <benchmark/benchmark.h>
#include <random>

#include "anatomy/patient.h"
#include "segmentation/deepest.h"
#include "segmentation/grow.h"
#include "segmentation/resample.h"
#include "segmentation/structures.h"
#include "shapes/find_liver.h"
#include "shapes/simulated_abdomen.h"
#include "shapes/smooth_model.h"

namespace {

using namespace glisson;
using Eigen::Vector3d;

constexpr float noise_hu = 25;

// The abdomen is made in coarse voxels without their noise's grain: each fine voxel gets its own.
const test::SimulatedAbdomen& large_abdomen() {
  static const test::SimulatedAbdomen made = [] {
    anatomy::PatientOptions options;
    options.seed = 7;
    const auto surface = anatomy::make_liver_surface(options, 4).value();
    const auto coarse = test::simulated_abdomen(surface, test::Looks::portal_ct, 3, 3);
    imaging::Grid grid = coarse.image.grid;
    const Vector3d middle_mm = geometry::mean_point_mm(surface);
    grid.spacing_mm = {0.75, 0.75, 1};
    grid.size = {512, 512, 300};
    grid.origin_mm = middle_mm - 0.5 * grid.spacing_mm.cwiseProduct(Vector3d(511, 511, 299)) + Vector3d(60, 0, 0);
    test::SimulatedAbdomen large{{segmentation::resample(coarse.image, grid), coarse.image.unit},
                                 segmentation::rasterise(surface, grid)};
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0, noise_hu);
    for (float& value : large.image.values) value += noise(random);
    return large;
  }();
  return made;
}

void report(benchmark::State& state, const imaging::Mask& found) {
  state.counters["dice"] = segmentation::dice(found, large_abdomen().liver).value();
}

void find_a_liver(benchmark::State& state) {
  const auto model = shapes::smooth_model().value();
  const test::SimulatedAbdomen& abdomen = large_abdomen();
  segmentation::GivenPoints points;
  if (state.range(0) > 0) points.inside_mm = {segmentation::deepest_mm(abdomen.liver)};
  for (auto _ : state) {
    const auto found = shapes::find_liver(abdomen.image, model, points);
    if (!found) return state.SkipWithError(found.error().message().c_str());
    report(state, found->liver.mask);
  }
}
BENCHMARK(find_a_liver)
    ->ArgName("points")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void grow_a_liver(benchmark::State& state) {
  const test::SimulatedAbdomen& abdomen = large_abdomen();
  const Vector3d seed_mm = segmentation::deepest_mm(abdomen.liver);
  for (auto _ : state) {
    const auto grown = segmentation::grow_from_seeds(abdomen.image, {seed_mm});
    if (!grown) return state.SkipWithError(grown.error().message().c_str());
    report(state, grown->mask);
  }
}
BENCHMARK(grow_a_liver)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
