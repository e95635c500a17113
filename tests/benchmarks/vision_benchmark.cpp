// How many stereo pairs a second. The pair is the real heart's, brought to 720 x 576 pixels.

#include <benchmark/benchmark.h>

#include "support/data.h"
#include "vision/stereo.h"

namespace glisson::vision {
namespace {

// Doubled in size: every pixel four times, which matching cannot tell from a picture that is out of focus.
Frame doubled(const Frame& frame) {
  Frame large{2 * frame.width, 2 * frame.height, std::vector<std::uint8_t>(4 * frame.rgb.size())};
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x) std::copy_n(frame.at(x / 2, y / 2), 3, large.at(x, y));
  return large;
}

// Rectification, masks, matching both ways, filter, points and triangles: everything from two pictures to a cloud.
void stereo_720x576(benchmark::State& state) {
  const auto folder = glisson::test::shared_data() / "hamlyn_heart_stereo";
  auto calibration = read_stereo_calibration(folder);
  const auto left = read_frame(folder / "f7_dynamic_deint_L_0100.png");
  const auto right = read_frame(folder / "f7_dynamic_deint_R_0100.png");
  if (!calibration || !left || !right) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  calibration->left.matrix.topRows<2>() *= 2;
  calibration->right.matrix.topRows<2>() *= 2;
  const Frame large_left = doubled(*left), large_right = doubled(*right);
  StereoOptions options;
  options.size = state.range(0) == 0 ? MatchingSize::full : MatchingSize::half;
  options.step_px = static_cast<int>(state.range(1));
  auto matcher = StereoMatcher::prepare(*calibration, large_left.width, large_left.height, options).value();
  std::size_t points = 0;
  for (auto _ : state) points = matcher.cloud(large_left, large_right).value().points_mm.size();
  state.counters["points"] = static_cast<double>(points);
  state.counters["pairs_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(stereo_720x576)
    ->ArgNames({"half", "step"})
    ->ArgsProduct({{0, 1}, {1, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace glisson::vision

BENCHMARK_MAIN();
