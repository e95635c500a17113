#include "studies/dissertation/internal/matching_timing.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "base/parallel.h"
#include "hardware/block_product.h"
#include "hardware/energy_meter.h"
#include "registration/trws.h"

namespace glisson::studies {
namespace {

using registration::Instructions;
using registration::Order;
using registration::Stopping;
using registration::TrwlsOptions;
using registration::WordWidth;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t largest_field_bytes = std::uint64_t{2} << 30;

struct Way {
  std::string name;
  int threads;
  std::function<Result<void>()> solve;
};

double seconds_of(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The number of threads for as long as this lives.
class Threads {
 public:
  explicit Threads(int threads) : before_(thread_count()) { set_thread_count(threads); }
  ~Threads() { set_thread_count(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

// The fastest of at least two registrations and `at_least_s`; a slow one is done once.
Result<MatchingTiming> timed(const Way& way, int points, double at_least_s, const hardware::EnergyMeter* meter) {
  const Threads threads(way.threads);
  MatchingTiming timing{points, way.name, way.threads};
  timing.seconds = 1e9;
  int runs = 0;
  double spent_s = 0;
  Result<void> solved;
  const double wanted_s = meter != nullptr ? std::max(at_least_s, meter->shortest_useful_s) : at_least_s;
  const auto repeat = [&]() -> Result<void> {
    while (spent_s < wanted_s && solved) {
      const double seconds = seconds_of([&] { solved = way.solve(); });
      timing.seconds = std::min(timing.seconds, seconds);
      spent_s += seconds;
      ++runs;
    }
    return solved;
  };
  if (meter == nullptr) {
    if (auto done = repeat(); !done) return failure(done.error());
    return timing;
  }
  const auto use = hardware::energy_during(*meter, repeat);
  if (!use) return failure(use.error());
  timing.watts = use->mean_W();
  timing.joules = use->joules / runs;
  return timing;
}

}  // namespace

TrwlsOptions as_in_table_3_1(int passes, WordWidth width) {
  TrwlsOptions options;
  options.passes = passes;
  options.stopping = Stopping::fixed_passes;
  options.polish = registration::Polish::none;
  options.starts = registration::Starts::one;
  options.width = width;
  return options;
}

Result<MatchingTimes> time_matching(const registration::MatchingProblem& problem, const MatchingOptions& options,
                                    const Progress& progress) {
  MatchingTimes times;
  const int points = problem.nodes();
  const int threads = thread_count();
  const auto survey = hardware::survey_meters();
  const hardware::EnergyMeter* meter = survey.meters.empty() ? nullptr : &survey.meters.front();
  for (const auto& missing : survey.missing) {
    if (meter == nullptr) times.remarks.push_back(missing.message());
  }
  times.memory_GB_per_s = hardware::memory_bandwidth_GB_s();

  const auto way = [&](const std::string& name, int with_threads, const TrwlsOptions& solving) {
    return Way{name, with_threads, [&problem, solving]() -> Result<void> {
                 const auto solution = registration::trwls(problem, solving);
                 if (!solution) return failure(solution.error());
                 return {};
               }};
  };
  const TrwlsOptions vectors = as_in_table_3_1(options.passes, WordWidth::bits_16);
  TrwlsOptions plain = vectors, naive = vectors;
  plain.instructions = Instructions::plain;
  naive.order = Order::naive;
  const std::string wide = fmt::format("TRWL-S, 16 bits, vectors ({})", registration::widest_instructions());
  std::vector<Way> ways;
  const auto field = registration::store(problem, largest_field_bytes);
  if (field) {
    ways.push_back({"TRW-S, double precision, field written out before", 1, [&]() -> Result<void> {
                      registration::trws(*field, {.passes = options.passes, .stopping = Stopping::fixed_passes});
                      return {};
                    }});
  } else {
    times.remarks.push_back(field.error().message());
  }
  ways.push_back(way("TRWL-S, double precision", 1, as_in_table_3_1(options.passes, WordWidth::double_precision)));
  ways.push_back(way("TRWL-S, 16 bits, plain code", 1, plain));
  ways.push_back(way(wide, 1, vectors));
  if (threads > 1) {
    ways.push_back(way(wide + ", naive schedule", threads, naive));
    ways.push_back(way(wide, threads, vectors));
  }
  if (options.device) {
    TrwlsOptions there = vectors;
    there.device = options.device;
    const auto first = registration::trwls(problem, there);  // compiles the kernels, which no timing is to hold
    if (!first) return failure(first.error());
    ways.push_back(way("TRWL-S, 16 bits, on the OpenCL device", 1, there));
  }
  ways.push_back(way("as GEO solves: stops by itself, polished, several starts", threads, TrwlsOptions{}));
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(i) / static_cast<double>(ways.size()), ways[i].name);
    const auto timing = timed(ways[i], points, options.seconds_a_timing, meter);
    if (!timing) return failure(timing.error());
    times.timings.push_back(*timing);
  }
  const double costs = options.passes * std::pow(points, 3) * (points - 1) * 1e-9;
  for (const MatchingTiming& timing : times.timings) {
    if (timing.name == wide) times.costs_G_per_s = std::max(times.costs_G_per_s, costs / timing.seconds);
  }
  return times;
}

}  // namespace glisson::studies
