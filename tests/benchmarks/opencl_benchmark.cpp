// What an OpenCL device gains: TRWL-S, the block product and a body's motion, on the processors and on the device, in
// one run. Where a figure is bound by memory or by arithmetic, the counters say how near to it.

#include <benchmark/benchmark.h>
#include <random>

#include "hardware/opencl_product.h"
#include "mechanics/bodies.h"
#include "mechanics/dynamics/implicit_euler.h"
#include "opencl/session.h"
#include "registration/problems.h"
#include "registration/trwls.h"

namespace {

using namespace glisson;

constexpr int on_processors = 0, on_device = 1;
std::optional<std::string> device_of(std::int64_t where) {
  return where == on_device ? std::optional<std::string>("") : std::nullopt;
}

// Passes of a field of n points each; "costs" are evaluations of eq. 3.2 a second.
void trwls_passes(benchmark::State& state) {
  const auto count = static_cast<int>(state.range(0));
  const registration::MatchingProblem problem = registration::test::shuffled_points(count, 6, 1).problem;
  registration::TrwlsOptions options;
  options.passes = 3;
  options.stopping = registration::Stopping::fixed_passes;
  options.polish = registration::Polish::none;  // which the processors do in either case
  options.device = device_of(state.range(1));
  for (auto _ : state) {
    const auto solution = registration::trwls(problem, options);
    if (!solution) return state.SkipWithError(solution.error().message().c_str());
    benchmark::DoNotOptimize(solution->energy);
  }
  const double costs = 2.0 * options.passes * double(problem.pairs_of_nodes()) * count * count;
  state.counters["costs"] = benchmark::Counter(costs, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(trwls_passes)
    ->ArgNames({"points", "device"})
    ->ArgsProduct({{32, 64, 128, 256, 512}, {on_processors, on_device}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void block_product(benchmark::State& state) {
  const auto nodes = static_cast<std::size_t>(state.range(0));
  constexpr int nodes_in_domain = 27;
  std::unique_ptr<hardware::ProductKernel> kernel = hardware::processor_product(nodes_in_domain, std::size_t{8} << 30);
  if (state.range(1) == on_device) {
    auto product = hardware::opencl_product(nodes_in_domain, std::size_t{8} << 30);
    if (!product) return state.SkipWithError(product.error().message().c_str());
    kernel = std::move(*product);
  }
  if (const auto ready = kernel->prepare(nodes); !ready) return state.SkipWithError(ready.error().message().c_str());
  constexpr int times = 10;
  for (auto _ : state) benchmark::DoNotOptimize(kernel->run(nodes, times));
  const double bytes = 4.0 * double(nodes) * times * (9 * nodes_in_domain + 3 * nodes_in_domain + 3);
  state.counters["bytes"] = benchmark::Counter(bytes, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(block_product)
    ->ArgNames({"nodes", "device"})
    ->ArgsProduct({{10'000, 100'000, 1'000'000}, {on_processors, on_device}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

// Steps of a soft beam that falls, held at one end: assembly on the processors, conjugate gradients where asked.
void motion_steps(benchmark::State& state) {
  const auto across = static_cast<int>(state.range(0));
  auto mesh = mechanics::test::box(3 * across, across, across, {60, 20, 20});
  mechanics::test::name_points(mesh, "wall", [](const Eigen::Vector3d& p) { return p.x() == 0; });
  mechanics::StaticOptions layout;
  layout.order = mechanics::ElementOrder::linear;
  layout.poisson_ratio = 0.45;
  std::vector<double> youngs_kPa(mesh.cells.size(), 5.0);
  auto body = mechanics::prepare_body(std::move(mesh), std::move(youngs_kPa), {mechanics::test::fixed("wall")}, layout,
                                      mechanics::Holding::optional);
  mechanics::DynamicsOptions options;
  options.max_iterations = 5000;
  options.device = device_of(state.range(1));
  auto moving = mechanics::ImplicitEuler::create(std::move(*body), mechanics::MaterialLaw::corotational, options);
  if (!moving) return state.SkipWithError(moving.error().message().c_str());
  const Eigen::VectorXd force = moving->force_of({mechanics::GravityLoad{{0, 0, -9810}}}).value();
  double iterations = 0;
  for (auto _ : state) {
    const mechanics::StepReport step = moving->step(force);
    if (!step.converged) return state.SkipWithError("a step did not converge");
    iterations += step.iterations;
  }
  state.counters["nodes"] = double(moving->displacement_mm().size()) / 3;
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(motion_steps)
    ->ArgNames({"across", "device"})
    ->ArgsProduct({{8, 16, 24}, {on_processors, on_device}})
    ->Iterations(20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  const auto devices = glisson::opencl::devices();
  benchmark::AddCustomContext("opencl", devices.empty() ? "no device" : devices.front());
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
