// A rehearsal with tools in contact on a case's own liver, its reference body (the atlas) beside it.
//
//   glisson-cli demo --out demo && GLISSON_CASE=demo/demo.glisson build/release/bin/bench_casefile

#include <benchmark/benchmark.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "benchmarks/exact_contact.h"
#include "casefile/model.h"
#include "rehearsal/session.h"
#include "rehearsal/tool_presets.h"

namespace glisson {
namespace {

using Eigen::Vector3d;

Result<casefile::PatientModel> model_of_case() {
  const char* folder = std::getenv("GLISSON_CASE");
  return casefile::Case::open(folder != nullptr ? folder : "demo/demo.glisson")
      .and_then([](const casefile::Case& patient) { return casefile::read_model(patient); });
}

// A retractor is pushed at segment VI with 2 N and held, and a probe of 0.3 N drawn over the front, half
// a millimetre a step, 80 steps there and back. `place_ms` is the retractor's first touch, `first_ms` a step of the
// probe's first way, on which each new place is solved for once; `error_mm` how far the last frame's landmarks are from
// those of a hundredfold tighter contact.
void SessionOnACase(benchmark::State& state) {
  auto model = model_of_case();
  if (!model) {
    state.SkipWithError(model.error().message().c_str());
    return;
  }
  const auto setup = casefile::rehearsal_setup(*model);
  const geometry::Surface surface = geometry::boundary_surface(setup.mesh);
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  const auto place = rehearsal::hoist_segment_vi(setup.mesh).value();
  const mechanics::ContactTool hook{
      "hook", mechanics::TouchingTool{mechanics::nathanson_retractor(),
                                      mechanics::pose_towards(place.center_mm - 40 * place.direction, place.direction),
                                      2000.0}};
  const Vector3d middle_mm = box.center_mm();
  int at = 0, step = 1;
  const auto probe = [&] {
    const Vector3d from_mm(middle_mm.x() + 0.5 * at, box.min_mm.y() - 20, middle_mm.z());
    return mechanics::ContactTool{"probe", mechanics::TouchingTool{mechanics::palpation_probe(),
                                                                   mechanics::pose_towards(from_mm, {0, 1, 0}), 300.0}};
  };
  auto engine = rehearsal::SessionEngine::create(setup).value();
  state.counters["cells"] = double(setup.mesh.cells.size());
  const std::clock_t before = std::clock();  // of all threads
  engine.step(rehearsal::HoldTool{hook});
  state.counters["place_cpu_ms"] = 1e3 * double(std::clock() - before) / CLOCKS_PER_SEC;
  state.counters["place_ms"] = engine.frame().step_ms;
  state.counters["place_solves"] = engine.frame().patient_step.report.new_solves;
  state.counters["moved_mm"] = engine.frame().patient.max_displacement_mm;
  double refused = engine.frame().refused.empty() ? 0 : 1;
  const auto draw = [&] {
    at += step;
    if (at == 0 || at == 80) step = -step;
    engine.step(rehearsal::HoldTool{probe()});
    refused += engine.frame().refused.empty() ? 0 : 1;
  };
  double first_ms = 0, first_slowest_ms = 0;
  for (int i = 0; i < 80; ++i) {
    draw();
    first_ms += engine.frame().step_ms / 80;
    first_slowest_ms = std::max(first_slowest_ms, engine.frame().step_ms);
  }
  double slowest_ms = 0, steps = 0;
  for (auto _ : state) {
    draw();
    slowest_ms = std::max(slowest_ms, engine.frame().step_ms);
    ++steps;
  }
  state.counters["steps_per_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["first_ms"] = first_ms;
  state.counters["first_slowest_ms"] = first_slowest_ms;
  state.counters["slowest_ms"] = slowest_ms;
  state.counters["refused"] = refused;

  state.counters["landmarks"] = double(setup.landmarks.size());
  state.counters["error_mm"] = landmark_error_mm(setup, hook, probe(), engine.frame());
}

BENCHMARK(SessionOnACase)->Iterations(160)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace glisson

BENCHMARK_MAIN();
