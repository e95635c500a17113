// Static elasticity on a body of a liver's size: what setting up costs, what each further load costs, what memory.
//
//   build/release/bin/bench_mechanics --benchmark_filter=SetUp

#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <ctime>

#include "base/parallel.h"
#include "benchmarks/exact_contact.h"
#include "mechanics/bodies.h"
#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/internal/meshfree_dynamics.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/statics/static_model.h"
#include "rehearsal/session.h"
#include "rehearsal/static_rehearsal.h"

namespace glisson {
namespace {

using Eigen::Vector3d;

// An ellipsoid of 1.5 litres, 6 n^3 cells, held at its upper rear.
geometry::TetMesh liver_sized(int n) {
  auto mesh = mechanics::test::bent_box(n, n, n, [](const Vector3d& unit) {
    const Vector3d p = 2 * unit - Vector3d(1, 1, 1);
    const double largest = p.cwiseAbs().maxCoeff();
    const Vector3d on_ball = largest > 0 ? Vector3d(p * largest / p.norm()) : p;
    return Vector3d(on_ball.cwiseProduct(Vector3d(90, 65, 61)));
  });
  mechanics::test::name_points(mesh, "bare_area", [](const Vector3d& p) { return p.y() > 20 && p.z() > 20; });
  mechanics::test::name_points(mesh, "diaphragm", [](const Vector3d& p) { return p.z() > 30; });
  return mesh;
}

const std::vector<mechanics::Support> supports{{mechanics::NamedPoints{"bare_area"}, mechanics::Fixed{}},
                                               {mechanics::NamedPoints{"diaphragm"}, mechanics::Foundation{1.1}}};
const mechanics::Loads hoist{mechanics::ToolLoad{{-60, 20, -40}, 25, {0, -3500, 3500}}};

void show(benchmark::State& state, const mechanics::StaticModel& model) {
  state.counters["cells"] = double(model.mesh().cells.size());
  state.counters["nodes"] = model.nodes().nodes();
  state.counters["matrix_MB"] = double(model.cost().matrix_bytes) / 1e6;
  state.counters["factor_MB"] = double(model.cost().factor_bytes) / 1e6;
}

void SetUp(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  for (auto _ : state) {
    const auto model = mechanics::StaticModel::create(mesh, mechanics::test::uniform(mesh, 6.0), supports).value();
    show(state, model);
  }
}

void OneLoad(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  const auto model = mechanics::StaticModel::create(mesh, mechanics::test::uniform(mesh, 6.0), supports).value();
  mechanics::StaticResult result;
  for (auto _ : state) result = model.solve(hoist).value();
  show(state, model);
  state.counters["relative_residual"] = result.relative_residual;
}

void SixteenLoadsTogether(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  const auto model = mechanics::StaticModel::create(mesh, mechanics::test::uniform(mesh, 6.0), supports).value();
  for (auto _ : state) benchmark::DoNotOptimize(model.solve_each(std::vector<mechanics::Loads>(16, hoist)));
  show(state, model);
}

// The meshfree engine offline: Voronoi nodes, shape functions, matrix, and what makes a step converge: a factor where
// there are few frames, two levels (reduced_solver.h) where there are many. Nodes, and cells 6 n^3. The CPU time is
// that of all threads.
void MeshfreeSetUp(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(1)));
  const auto youngs_kPa = mechanics::test::uniform(mesh, 6.0);
  for (auto _ : state) {
    const auto model = mechanics::MeshfreeModel::create(mesh, youngs_kPa, supports, mechanics::MaterialLaw::linear, {},
                                                        {.nodes = int(state.range(0))})
                           .value();
    state.counters["cells"] = double(mesh.cells.size());
    state.counters["unknowns"] = double(model.cost().unknowns);
    state.counters["matrix_MB"] = double(model.cost().matrix_bytes) / 1e6;
    state.counters["factor_MB"] = double(model.cost().factor_bytes) / 1e6;
  }
}

// And what it costs to move: steps of 20 ms under a constant load from rest, to a relative residual of 1e-3.
void CostOfNodes(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(1)));
  const std::clock_t before = std::clock();
  auto frames = mechanics::prepare_meshfree_body(mesh, mechanics::test::uniform(mesh, 6.0), supports,
                                                 mechanics::MaterialLaw::linear, {}, {.nodes = int(state.range(0))}, {},
                                                 mechanics::Holding::required)
                    .value();
  state.counters["matrix_MB"] = double(frames.rest_stiffness.bytes()) / 1e6;
  auto moving =
      mechanics::MeshfreeImplicitEuler::create(std::move(frames), {.relative_tolerance = 1e-3, .max_iterations = 2000})
          .value();
  state.counters["setup_s"] = double(std::clock() - before) / CLOCKS_PER_SEC;  // CPU time of all threads
  const auto loads = mechanics::applied_loads(moving.body(), hoist, mechanics::PressureKind::dead).value();
  double iterations = 0, worst = 0, steps = 0;
  for (auto _ : state) {
    const auto report = moving.step(loads);
    iterations += report.iterations;
    worst = std::max(worst, report.relative_residual);
    ++steps;
  }
  state.counters["nodes"] = double(state.range(0));
  state.counters["cells"] = double(mesh.cells.size());
  state.counters["iterations"] = iterations / steps;
  state.counters["worst_residual"] = worst;
}

// How far the meshfree engine is from finite elements on a liver of uneven stiffness (3 to 20 kPa), by its nodes and by
// what holds the upper rear: 1 held points, 0 the springs of a foundation.
void MeshfreeAgainstCells(benchmark::State& state) {
  const auto mesh = liver_sized(11);
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Vector3d at = geometry::cell_centroid_mm(mesh, c);
    youngs_kPa.push_back(8.0 * std::exp(0.9 * std::sin(0.05 * at.x()) * std::cos(0.07 * at.y())));
  }
  auto by = supports;
  if (state.range(1) == 0) by[0].how = mechanics::Foundation{1.1};
  const auto cells = mechanics::solve_static(mesh, youngs_kPa, by, hoist).value();
  for (auto _ : state) {
    const auto model = mechanics::MeshfreeModel::create(mesh, youngs_kPa, by, mechanics::MaterialLaw::linear, {},
                                                        {.nodes = int(state.range(0))})
                           .value();
    const auto frames = model.solve(hoist).value();
    double sum_mm = 0, largest_mm = 0;
    for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
      const double apart_mm = (frames.displacement_mm[p] - cells.displacement_mm[p]).norm();
      sum_mm += apart_mm;
      largest_mm = std::max(largest_mm, apart_mm);
    }
    state.counters["mean_mm"] = sum_mm / double(mesh.points_mm.size());
    state.counters["largest_mm"] = largest_mm;
    state.counters["moved_mm"] = cells.max_displacement_mm;
    state.counters["work_share"] = frames.external_work_uJ / cells.external_work_uJ;
  }
}

// A step in time of a body as large as one likes: what it costs to make and to move, and in memory.
void CostOfCells(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  mechanics::StaticOptions options;
  options.order = mechanics::ElementOrder::linear;
  const auto start = std::chrono::steady_clock::now();
  auto body = mechanics::prepare_body(mesh, mechanics::test::uniform(mesh, 6.0), supports, options,
                                      mechanics::Holding::required)
                  .value();
  auto moving = mechanics::ImplicitEuler::create(std::move(body), mechanics::MaterialLaw::corotational,
                                                 {.relative_tolerance = 1e-3, .max_iterations = 1000})
                    .value();
  state.counters["setup_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto force_mN = moving.force_of(hoist).value();
  double iterations = 0, unconverged = 0, steps = 0;
  for (auto _ : state) {
    const auto report = moving.step(force_mN);
    iterations += report.iterations;
    unconverged += report.converged ? 0 : 1;
    ++steps;
  }
  state.counters["cells"] = double(mesh.cells.size());
  state.counters["nodes"] = double(moving.mass_kg().size());
  state.counters["matrix_MB"] = double(moving.cost().product_bytes) / 1e6;
  state.counters["iterations"] = iterations / steps;
  state.counters["unconverged"] = unconverged;
}

// What the window waits for: a tool put down (both bodies solved), and a force changed.
void PlacingATool(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  const auto rehearsal =
      rehearsal::StaticRehearsal::create({mesh, mechanics::test::uniform(mesh, 6.0), 5.0, supports, {}, {}, {}, {}})
          .value();
  for (auto _ : state) benchmark::DoNotOptimize(rehearsal.place_tool({-60, 20, -40}, 25).value());
}

void ChangingTheForce(benchmark::State& state) {
  const auto mesh = liver_sized(int(state.range(0)));
  const auto rehearsal =
      rehearsal::StaticRehearsal::create({mesh, mechanics::test::uniform(mesh, 6.0), 5.0, supports, {}, {}, {}, {}})
          .value();
  const auto tool = rehearsal.place_tool({-60, 20, -40}, 25).value();
  double force_N = 0;
  for (auto _ : state) {
    force_N += 0.001;
    benchmark::DoNotOptimize(tool.answer({0, -force_N, force_N}));
  }
}

// A hand that draws a probe over the liver, half a millimetre a step, while a retractor holds it: both bodies, contact
// found anew, landmarks, digest. `first` is the first way over the surface, on which each new place is solved for once;
// `error_mm` is how far the last frame's landmarks are from those of a hundredfold tighter contact.
void RehearsalWithTools(benchmark::State& state) {
  const auto mesh = liver_sized(15);
  rehearsal::RehearsalSetup setup{mesh, mechanics::test::uniform(mesh, 6.0), 5.0, supports, {}, {}, {}, {}};
  setup.landmarks = {{"a", {-40, -30, -20}}, {"b", {0, -50, 0}}, {"c", {30, -20, 10}}};
  auto engine = rehearsal::SessionEngine::create(setup).value();
  const mechanics::ContactTool hook{"hook",
                                    mechanics::TouchingTool{mechanics::nathanson_retractor(),
                                                            mechanics::pose_towards({-40, 0, -80}, {0, 0, 1}), 500.0}};
  int at = 0, step = 1;
  const auto probe = [&] {
    return mechanics::ContactTool{
        "probe", mechanics::TouchingTool{mechanics::palpation_probe(),
                                         mechanics::pose_towards({-30 + 0.5 * at, -90, -10}, {0, 1, 0}), 300.0}};
  };
  engine.step(rehearsal::HoldTool{hook});
  const auto draw = [&] {
    at += step;
    if (at == 0 || at == 80) step = -step;
    engine.step(rehearsal::HoldTool{probe()});
  };
  double first_ms = 0, slowest_ms = 0, refused = 0, steps = 0;
  for (int i = 0; i < 80; ++i) {
    draw();
    first_ms += engine.state().step_ms / 80;
  }
  for (auto _ : state) {
    draw();
    slowest_ms = std::max(slowest_ms, engine.state().step_ms);
    refused += engine.state().refused.empty() ? 0 : 1;
    ++steps;
  }
  state.counters["steps_per_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["first_ms"] = first_ms;
  state.counters["slowest_ms"] = slowest_ms;
  state.counters["refused"] = refused;

  state.counters["error_mm"] = landmark_error_mm(setup, hook, probe(), engine.state());
}

// The beam of SOFA's published figures by its number of nodes: 16 x 16 x 76 = 19,456, corotational, clamped at one end,
// swinging under gravity from rest. 45 x 45 x 225 mm, nu = 0.45, 1000 kg/m3, steps of 20 ms, each converged to a
// relative residual of 1e-3 or better.
void CorotationalBeamStep(benchmark::State& state) {
  auto mesh = mechanics::test::box(15, 15, 75, {45, 45, 225});
  mechanics::test::name_points(mesh, "wall", [](const Vector3d& p) { return p.z() == 0; });
  mechanics::StaticOptions options;
  options.order = mechanics::ElementOrder::linear;
  auto body = mechanics::prepare_body(mesh, mechanics::test::uniform(mesh, double(state.range(0))),
                                      {mechanics::test::fixed("wall")}, options, mechanics::Holding::required)
                  .value();
  auto moving = mechanics::ImplicitEuler::create(std::move(body), mechanics::MaterialLaw::corotational,
                                                 {.relative_tolerance = 1e-3})
                    .value();
  const auto force_mN = moving.force_of({mechanics::GravityLoad{{0, -9810, 0}}}).value();
  double iterations = 0, worst = 0, unconverged = 0, steps = 0;
  for (auto _ : state) {
    const auto report = moving.step(force_mN);
    iterations += report.iterations;
    worst = std::max(worst, report.relative_residual);
    unconverged += report.converged ? 0 : 1;
    ++steps;
  }
  state.counters["steps_per_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["iterations"] = iterations / steps;
  state.counters["worst_residual"] = worst;
  state.counters["unconverged"] = unconverged;
  state.counters["product_MB"] = double(moving.cost().product_bytes) / 1e6;
  state.counters["lattice_points"] = double(moving.cost().lattice_points);
}

// What the memory gives: both cores read a matrix of that size over and over and add it up.
void ReadingMemory(benchmark::State& state) {
  const std::vector<float> values(std::size_t(state.range(0)) * 250'000, 1.0F);
  for (auto _ : state) {
    parallel_for(64, 1, [&](std::size_t begin, std::size_t end) {
      const std::size_t part = values.size() / 64;
      Eigen::Map<const Eigen::ArrayXf> range(values.data() + begin * part, Eigen::Index((end - begin) * part));
      benchmark::DoNotOptimize(range.sum());
    });
  }
  state.SetBytesProcessed(state.iterations() * std::int64_t(values.size() * sizeof(float)));
}

BENCHMARK(RehearsalWithTools)->Iterations(200)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(CorotationalBeamStep)->Arg(6)->Arg(60)->Iterations(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ReadingMemory)->Arg(12)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();  // MB

// 6 n^3: 4,374, 20,250 and 93,750 cells.
BENCHMARK(SetUp)->Arg(9)->Arg(15)->Arg(25)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(OneLoad)->Arg(9)->Arg(15)->Arg(25)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(SixteenLoadsTogether)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(MeshfreeAgainstCells)
    ->ArgsProduct({{30, 100, 300}, {1, 0}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
// 6 n^3: 1,296 to 511,104 cells.
BENCHMARK(CostOfCells)->Arg(6)->Arg(9)->Arg(15)->Arg(25)->Iterations(10)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(CostOfCells)->Arg(44)->Iterations(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(MeshfreeSetUp)
    ->Args({100, 15})
    ->Args({2000, 15})
    ->Args({20000, 25})
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
// From 12 points of the mesh a node, as where no number is asked for, to 4.
BENCHMARK(CostOfNodes)
    ->Args({30, 6})
    ->Args({100, 9})
    ->Args({340, 15})
    ->Args({1460, 25})
    ->Args({4000, 25})
    ->Args({20000, 44})
    ->Iterations(3)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(PlacingATool)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ChangingTheForce)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace glisson

BENCHMARK_MAIN();
