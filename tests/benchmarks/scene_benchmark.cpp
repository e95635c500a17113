// Drawing at the demo patient's size (256 x 208 x 70): one movement of the brush, the outline of a slice, and a stroke
// saved with its step of undo, taken back again.

#include <benchmark/benchmark.h>

#include "base/files.h"
#include "casefile/history.h"
#include "casefile/structures.h"
#include "scene/drawing.h"
#include "segmentation/brush.h"
#include "segmentation/edit.h"

namespace glisson {
namespace {

imaging::Mask liver_sized() {
  imaging::Mask mask;
  mask.grid.size = {256, 208, 70};
  mask.grid.spacing_mm = {1.6, 1.6, 3.3};
  mask.values.assign(mask.grid.voxels(), 0);
  return segmentation::paint(std::move(mask), {mask.grid.position_mm(Eigen::Vector3d(128, 104, 35)), 80});
}

void brush_moves(benchmark::State& state) {
  imaging::Mask mask = liver_sized();
  const Eigen::Vector3d from = mask.grid.position_mm(Eigen::Vector3d(100, 100, 35));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        segmentation::draw(mask, {from, from + Eigen::Vector3d(4, 2, 0), 10, {}}, segmentation::Paint::add));
  }
}
BENCHMARK(brush_moves)->Unit(benchmark::kMicrosecond);

void layer_outlined(benchmark::State& state) {
  const imaging::Mask mask = liver_sized();
  for (auto _ : state) benchmark::DoNotOptimize(scene::outline_in_layer(mask, 2, 35));
}
BENCHMARK(layer_outlined)->Unit(benchmark::kMicrosecond);

void stroke_saved_and_undone(benchmark::State& state) {
  const TemporaryFolder temporary;
  const auto folder = temporary.path() / "patient.glisson";
  (void)casefile::Case::create(folder);
  const auto history = casefile::History::open(folder);
  imaging::Mask mask = liver_sized();
  const auto save = [&] {
    auto opened = casefile::Case::open(folder);
    return casefile::save_structure(*opened, segmentation::make_structure("liver", mask), {"segment", {}, {}, {}, {}})
        .map([](const auto&) {});
  };
  (void)save();
  const imaging::Mask before = mask;
  for (auto _ : state) {
    mask = before;
    const Eigen::Vector3d at = mask.grid.position_mm(Eigen::Vector3d(60, 100, 35));
    segmentation::draw(mask, {at, at, 12, {}}, segmentation::Paint::add);
    if (!(*history)->record({"Brush", {}}, save, {"labels/liver"})) state.SkipWithError("not saved");
    if (!(*history)->undo()) state.SkipWithError("not undone");
  }
  state.counters["bytes_of_history"] = static_cast<double>((*history)->disk_bytes());
}
BENCHMARK(stroke_saved_and_undone)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glisson

BENCHMARK_MAIN();
