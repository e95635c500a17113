// The block product against the machine's memory: bytes, operations, and the share of the bandwidth it reaches.
//
//   bench_hardware --benchmark_min_time=0.2

#include <benchmark/benchmark.h>

#include "hardware/block_product.h"
#include "hardware/workload.h"

namespace glisson::hardware {
namespace {

double bandwidth_GB_s() {
  static const double measured = memory_bandwidth_GB_s();
  return measured;
}

void block_product(benchmark::State& state) {
  const auto nodes = static_cast<std::size_t>(state.range(0));
  const int domain = static_cast<int>(state.range(1));
  const auto kernel = processor_product(domain, std::size_t{2} << 30);
  if (!kernel->prepare(nodes)) {
    state.SkipWithError("not enough memory");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(kernel->run(nodes, 1));
  const auto work = workload_at_resolution(1000, 1e6 / static_cast<double>(nodes), {domain, 1, 4});
  const double products = static_cast<double>(state.iterations());
  state.counters["GB/s"] = benchmark::Counter(work->product_bytes * products * 1e-9, benchmark::Counter::kIsRate);
  state.counters["GFLOP/s"] = benchmark::Counter(work->product_flops * products * 1e-9, benchmark::Counter::kIsRate);
  state.counters["share"] =
      benchmark::Counter(work->product_bytes * products * 1e-9 / bandwidth_GB_s(), benchmark::Counter::kIsRate);
  state.SetLabel(kernel->name());
}
// The grid's smallest and largest problems with 3 x 3 blocks, and a middle one with 3 x 81.
BENCHMARK(block_product)->Args({5455, 1})->Args({60000, 1})->Args({1636364, 1})->Args({60000, 27})->UseRealTime();

void memory_triad(benchmark::State& state) {
  for (auto _ : state) state.counters["GB/s"] = memory_bandwidth_GB_s();
}
BENCHMARK(memory_triad)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace glisson::hardware

BENCHMARK_MAIN();
