// Opening a plan and answering a cut that is dragged, on a grid of 512 x 512 x 300.
//
//   build/release/bin/bench_planning

#include <benchmark/benchmark.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "planning/planner.h"
#include "vasculature/territories.h"

namespace {

using namespace glisson;
using Eigen::Vector3d;
using planning::Planner;
using vasculature::System;

// A liver of ordinary size: an egg with a lobe, 0.7 x 0.7 x 1 mm.
imaging::Mask liver() {
  imaging::Mask mask;
  mask.grid.size = {512, 512, 300};
  mask.grid.spacing_mm = {0.7, 0.7, 1.0};
  mask.grid.origin_mm = {-179, -179, -150};
  mask.values.assign(mask.grid.voxels(), 0);
  for (int k = 0; k < 300; ++k) {
    for (int j = 0; j < 512; ++j) {
      for (int i = 0; i < 512; ++i) {
        const Vector3d at = mask.grid.position_mm(i, j, k);
        const Vector3d right = (at - Vector3d(-30, 0, 0)).cwiseQuotient(Vector3d(65, 72, 78));
        const Vector3d left = (at - Vector3d(50, -25, 20)).cwiseQuotient(Vector3d(70, 35, 30));
        if (right.norm() < 1 || left.norm() < 1) mask.at(i, j, k) = 1;
      }
    }
  }
  return mask;
}

// A tree that divides in two, nine times.
void grow(vasculature::VesselTrees& trees, System system, int parent, const Vector3d& from, const Vector3d& way,
          double length_mm, double radius_mm, int divisions, std::mt19937_64& random) {
  vasculature::TreeBranch branch;
  branch.system = system;
  branch.parent = parent;
  branch.name = system == System::portal_vein ? "portal" : "hepatic";
  const int steps = std::max(3, static_cast<int>(length_mm));
  for (int n = 0; n <= steps; ++n) branch.points.push_back({from + way * (length_mm * n / steps), radius_mm});
  const Vector3d tip = branch.points.back().position_mm;
  const int here = static_cast<int>(trees.branches.size());
  trees.branches.push_back(std::move(branch));
  if (divisions == 0) return;
  std::normal_distribution<double> turn(0, 0.6);
  for (int child = 0; child < 2; ++child) {
    const Vector3d towards = (way + Vector3d(turn(random), turn(random), turn(random))).normalized();
    grow(trees, system, here, tip, towards, 0.82 * length_mm, 0.78 * radius_mm, divisions - 1, random);
  }
}

planning::LiverParts parts() {
  planning::LiverParts parts;
  parts.liver = liver();
  std::mt19937_64 random(7);
  grow(parts.trees, System::portal_vein, -1, {0, 0, -40}, {-0.5, 0, 0.86}, 40, 6, 8, random);
  grow(parts.trees, System::hepatic_vein, -1, {0, 40, 60}, {-0.4, -0.5, -0.77}, 40, 6, 8, random);
  for (const System system : {System::portal_vein, System::hepatic_vein}) {
    const auto found = vasculature::territories_of(parts.trees, system, parts.liver);
    imaging::LabelMap map{parts.liver.grid, {}};
    for (const std::int32_t branch : found->branch) map.values.push_back(static_cast<std::uint16_t>(branch + 1));
    (system == System::portal_vein ? parts.portal : parts.hepatic) = std::move(map);
  }
  parts.segments = imaging::LabelMap{parts.liver.grid, std::vector<std::uint16_t>(parts.liver.values.size(), 0)};
  imaging::Volume stiffness;
  stiffness.grid = parts.liver.grid;
  stiffness.grid.size = {128, 128, 60};
  stiffness.grid.spacing_mm = {2.8, 2.8, 5};
  stiffness.values.assign(stiffness.grid.voxels(), 6.0F);
  parts.youngs_kPa = std::move(stiffness);
  for (const double x : {-50.0, -20.0, 40.0}) {
    planning::NamedTumour tumour{"tumour-" + std::to_string(parts.tumours.size() + 1),
                                 {parts.liver.grid, std::vector<std::uint8_t>(parts.liver.values.size(), 0)}};
    const Vector3d center(x, -10, 20);
    for (std::size_t v = 0, k = 0; k < 300; ++k) {
      for (int j = 0; j < 512; ++j) {
        for (int i = 0; i < 512; ++i, ++v) {
          if (parts.liver.values[v] == 0) continue;
          const Vector3d at = parts.liver.grid.position_mm(i, j, static_cast<int>(k));
          parts.segments->values[v] =
              static_cast<std::uint16_t>(1 + (at.x() > 0 ? 1 : 0) + (at.y() > 0 ? 2 : 0) + (at.z() > 0 ? 4 : 0));
          if ((at - center).norm() < 15) tumour.mask.values[v] = 1;
        }
      }
    }
    parts.tumours.push_back(std::move(tumour));
  }
  return parts;
}

const planning::LiverParts& one_liver() {
  static const planning::LiverParts made = parts();
  return made;
}
const Planner& opened() {
  static const Planner made = *Planner::open(one_liver());
  return made;
}

// The last figure of each is the fastest: what else a machine does only makes an answer slower.
template <int repetitions>
void fastest_of(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(repetitions)->ReportAggregatesOnly();
  benchmark->ComputeStatistics(
      "fastest", [](const std::vector<double>& times) { return *std::min_element(times.begin(), times.end()); });
}

void open(benchmark::State& state) {
  const auto& parts = one_liver();
  for (auto _ : state) benchmark::DoNotOptimize(Planner::open(parts));
}
BENCHMARK(open)->Apply(fastest_of<5>);

void drag(benchmark::State& state, const std::vector<planning::Cut>& start) {
  const Planner& planner = opened();
  std::vector<planning::Cut> cuts = start;
  double way = 0.5;
  int frame = 0;
  for (auto _ : state) {
    if (auto* plane = std::get_if<planning::PlaneCut>(&cuts.front())) plane->point_mm.x() += way;
    if (auto* sheet = std::get_if<planning::SheetCut>(&cuts.front())) sheet->through_mm[5].x() += way;
    if (++frame % 20 == 0) way = -way;
    auto answer = planner.answer(cuts);
    if (!answer) state.SkipWithError(answer.error().message().c_str());
    benchmark::DoNotOptimize(answer);
  }
}
planning::SheetCut sheet() {
  planning::SheetCut cut;
  for (const double y : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
    for (const double z : {-60.0, -20.0, 20.0, 60.0}) cut.through_mm.emplace_back(10 * std::sin(y / 30), y, z);
  }
  return cut;
}
BENCHMARK_CAPTURE(drag, plane, {planning::PlaneCut{{0, 0, 0}, {1, 0.2, 0.1}, planning::Removed::smaller}})
    ->Apply(fastest_of<15>);
BENCHMARK_CAPTURE(drag, sheet_of_20_points, {sheet()})->Apply(fastest_of<15>);
BENCHMARK_CAPTURE(drag, segments, {planning::SegmentsCut{{6, 7}}})->Apply(fastest_of<15>);
BENCHMARK_CAPTURE(drag, around_a_tumour, {planning::MarginCut{"tumour-1", 10}})->Apply(fastest_of<15>);
BENCHMARK_CAPTURE(drag, plane_and_two_tumours,
                  {planning::PlaneCut{{-60, 0, 0}, {1, 0.2, 0.1}, planning::Removed::smaller},
                   planning::MarginCut{"tumour-2", 10}, planning::MarginCut{"tumour-3", 20}})
    ->Apply(fastest_of<15>);

// The same plane with its surface unrolled, as Resect shows it while it is dragged.
void drag_unrolled(benchmark::State& state) {
  planning::PlaneCut plane{{0, 0, 0}, {1, 0.2, 0.1}, planning::Removed::smaller};
  for (auto _ : state) {
    plane.point_mm.x() += 0.5;
    auto answer = opened().answer_unrolled({plane});
    if (!answer) state.SkipWithError(answer.error().message().c_str());
    benchmark::DoNotOptimize(answer);
  }
}
BENCHMARK(drag_unrolled)->Apply(fastest_of<15>);

}  // namespace

BENCHMARK_MAIN();
