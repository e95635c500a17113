// TRWL-S against TRW-S on the same problems in one run: word widths, sizes, real shapes. And SIRGn at the
// dissertation's size.
//
//   bench_registration                                       the sweep below (minutes)
//   bench_registration --benchmark_filter='n:128|pairs'      the targets
//   bench_registration --benchmark_filter=roofline           how near the vectors are to what the processor can do
//   bench_registration --benchmark_filter=correct_matches    the curve of correct matches
//   bench_registration --benchmark_filter='pairs/n:64'       56 pairs in a minute
//   bench_registration --benchmark_filter='pairs/n:128'      56 pairs; the first time their baselines take 4 minutes
//                                                            and 1 GB, later runs find them in GLISSON_BASELINES
//                                                            (a file; by default in the build folder)
//
// `ratio_*` are of times in this run. They are to `trws` with the field given, with writing out the field counted in,
// and to a TRW-S that evaluates its field, exponential and all, whenever a message needs it. That one would have to
// store nothing but its two matrices. Its time is estimated: the passes' cells times the time that writing out took a
// cell.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <tuple>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/files.h"
#include "base/json.h"
#include "base/parallel.h"
#include "geometry/mesh_file.h"
#include "hardware/energy_meter.h"
#include "registration/breathing_liver.h"
#include "registration/geo.h"
#include "registration/internal/trwls_simd.h"
#include "registration/samples.h"
#include "registration/trwls.h"
#include "registration/trws.h"
#include "registration_quality/sequences.h"
#include "support/data.h"
#include "support/folders.h"

namespace glisson::registration {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Of all threads: what a registration costs on a busy machine too.
double cpu_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Samples of a shape from different starts, so that one pair of shapes gives many problems.
const GeodesicSamples* samples_of(const std::string& name, int start, int points = 256) {
  static std::map<std::tuple<std::string, int, int>, GeodesicSamples> known;
  const auto place = known.find({name, start, points});
  if (place != known.end()) return &place->second;
  const std::filesystem::path file = glisson::test::shared_data() / name;
  const auto surface = geometry::read_surface(file);
  if (!surface) return nullptr;
  auto samples = sample_surface(*surface, points, start);
  if (!samples) return nullptr;
  samples->to_surface_mm.resize(0, 0);
  return &known.emplace(std::tuple(name, start, points), std::move(*samples)).first->second;
}

MatchingProblem problem_of(const GeodesicSamples& a, const GeodesicSamples& b, int n) {
  MatchingProblem problem;
  problem.source_mm = a.between_mm.topLeftCorner(n, n);
  problem.target_mm = b.between_mm.topLeftCorner(n, n);
  // About what GEO uses: half and three tenths of the square root of the area, itself 0.8 of the largest distance.
  problem.sigma_mm = 0.4 * b.between_mm.maxCoeff();
  problem.tau_mm = 0.25 * b.between_mm.maxCoeff();
  return problem;
}

const std::string wolf0 = "tosca_nonrigid_shapes/wolf0.off";
const std::string wolf1 = "tosca_nonrigid_shapes/wolf1.off";

std::optional<MatchingProblem> wolves(int n) {
  const GeodesicSamples* a = samples_of(wolf0, 0);
  const GeodesicSamples* b = samples_of(wolf1, 1000);
  if (a == nullptr || b == nullptr) return std::nullopt;
  return problem_of(*a, *b, n);
}

struct Baseline {
  double store_ms = 0;
  double solve_ms = 0;
  double solve_cpu_ms = 0;
  double energy = 0;
};

// Measured once a size. Above n = 128 the written-out field does not fit in 2 GB: then nothing.
std::optional<Baseline> baseline(const MatchingProblem& problem) {
  static std::map<int, Baseline> known;
  const auto place = known.find(problem.nodes());
  if (place != known.end()) return place->second;
  const auto start = Clock::now();
  const auto mrf = store(problem, std::uint64_t{2} << 30);
  if (!mrf) return std::nullopt;
  Baseline measured;
  measured.store_ms = ms_since(start);
  const double before_ms = cpu_ms();
  const MatchingSolution solution = trws(*mrf, {.stopping = Stopping::fixed_passes});
  measured.solve_ms = solution.solve_ms;
  measured.solve_cpu_ms = cpu_ms() - before_ms;
  measured.energy = solution.energy;
  return known.emplace(problem.nodes(), measured).first->second;
}

// trwls on the wolves: n, threads, dynamic (1) or 20 passes (0).
void trwls_wolves(benchmark::State& state) {
  const auto problem = wolves(static_cast<int>(state.range(0)));
  if (!problem) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  set_thread_count(static_cast<int>(state.range(1)));
  TrwlsOptions options;
  if (state.range(2) == 0) {
    options.stopping = Stopping::fixed_passes;
    options.polish = Polish::none;  // as the baseline
  }
  double minimum_ms = 1e9, minimum_cpu_ms = 1e9;
  MatchingSolution solution;
  for (auto _ : state) {
    const double before_ms = cpu_ms();
    solution = trwls(*problem, options).value();
    minimum_ms = std::min(minimum_ms, solution.solve_ms);
    minimum_cpu_ms = std::min(minimum_cpu_ms, cpu_ms() - before_ms);
  }
  set_thread_count(0);
  state.SetLabel(widest_instructions());
  state.counters["least_ms"] = minimum_ms;
  state.counters["least_cpu_ms"] = minimum_cpu_ms;  // of all threads
  state.counters["passes"] = static_cast<double>(solution.passes.size());
  if (const auto base = baseline(*problem)) {
    const double cells =
        0.5 * static_cast<double>(problem->nodes()) * (problem->nodes() - 1) * problem->labels() * problem->labels();
    const double evaluated_ms = base->solve_ms + base->store_ms / cells * (20 * 2 * cells);
    state.counters["ratio_given"] = base->solve_ms / minimum_ms;
    state.counters["ratio_given_cpu"] = base->solve_cpu_ms / minimum_cpu_ms;  // work against work, on busy machines too
    state.counters["ratio_with_field"] = (base->store_ms + base->solve_ms) / minimum_ms;
    state.counters["ratio_evaluated"] = evaluated_ms / minimum_ms;
    state.counters["energy_%"] = 100 * (solution.energy / base->energy - 1);
    state.counters["trws_ms"] = base->solve_ms;
    state.counters["field_ms"] = base->store_ms;
  }
}
BENCHMARK(trwls_wolves)
    ->ArgNames({"n", "threads", "dynamic"})
    ->ArgsProduct({{96, 128, 192, 256}, {1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// How near the vectors are to what this processor can do with the seven operations that a cost takes (difference, its
// size, cut at tau, larger weight, product, sum, least): costs a second of one core, in the kernel as it is called (12
// messages of one node, 128 labels) and in registers alone. The fastest of many short runs each, so that other programs
// hardly matter. floor_ms is what 20 passes at n = 128 would take two cores at that rate.
#if defined(__x86_64__)
__attribute__((target("avx512f,avx512bw"), noinline)) void costs_in_registers(int rounds, __m512i* minimum) {
  __m512i y = _mm512_set1_epi16(1234), weight = _mm512_set1_epi16(3333), start = _mm512_set1_epi16(10);
  const __m512i x = _mm512_set1_epi16(99), x_weight = _mm512_set1_epi16(77), tau = _mm512_set1_epi16(5000);
  __m512i best[8];
  for (__m512i& each : best) each = _mm512_set1_epi16(30000);
  for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 8
    for (__m512i& each : best) {
      asm volatile("" : "+v"(y), "+v"(weight), "+v"(start));  // nothing is known to stay the same
      const __m512i difference = _mm512_min_epu16(_mm512_abs_epi16(_mm512_sub_epi16(y, x)), tau);
      const __m512i cost = _mm512_mulhi_epu16(_mm512_max_epu16(weight, x_weight), difference);
      each = _mm512_min_epu16(each, _mm512_add_epi16(start, cost));
    }
  }
  for (int i = 0; i < 8; ++i) _mm512_storeu_si512(minimum + i, best[i]);
}
#endif

void cost_roofline(benchmark::State& state) {
  constexpr int labels = 128, messages = 12, repeats = 20000;
  std::mt19937 random(1);
  const auto fill = [&](auto& words, unsigned maximum) {
    for (auto& word : words) word = static_cast<std::uint16_t>(random() % maximum);
  };
  Slices<std::uint16_t> slices;
  slices.nodes = slices.labels = slices.stride = labels;
  slices.tau = slices.largest_cost = 8000;
  slices.y.resize(labels * labels);
  slices.y_weight.resize(labels * labels);
  fill(slices.y, 32000);
  fill(slices.y_weight, 65000);
  AlignedVector<std::uint16_t> belief(labels), scratch(4 * labels), reverse(messages * labels), updated(reverse.size());
  fill(belief, 8000);
  fill(reverse, 8000);
  const AlignedVector<std::uint16_t> one_more_from(labels, 6);
  const SharedBelief<std::uint16_t> shared{belief.data(), one_more_from.data()};
  std::vector<Message<std::uint16_t>> chunk;
  for (std::size_t m = 0; m < messages; ++m) {
    chunk.push_back({reverse.data() + m * labels, updated.data() + m * labels, static_cast<std::uint16_t>(1000 * m),
                     static_cast<std::uint16_t>(60000 - 3000 * m), static_cast<int>(m)});
  }
  const SliceKernels<std::uint16_t> kernels = simd_kernels();
  double kernel_ms = 1e9, registers_ms = 1e9;
  for (auto _ : state) {
    for (int i = 0; i < repeats; ++i) {
      const auto start = Clock::now();
      benchmark::DoNotOptimize(kernels.send(slices, shared, chunk.data(), messages, scratch.data()));
      kernel_ms = std::min(kernel_ms, ms_since(start));
    }
  }
  const double costs = 1.0 * messages * labels * labels;
  state.SetLabel(widest_instructions());
  state.counters["kernel_G_a_s"] = 1e-6 * costs / kernel_ms;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512bw") == 0) return;
  constexpr int rounds = 1000;
  __m512i minimum[8];
  for (int i = 0; i < repeats / 4; ++i) {
    const auto start = Clock::now();
    costs_in_registers(rounds, minimum);
    benchmark::DoNotOptimize(minimum);
    registers_ms = std::min(registers_ms, ms_since(start));
  }
  const double maximum = 8.0 * 32 * rounds / registers_ms;
  state.counters["registers_G_a_s"] = 1e-6 * maximum;
  state.counters["share_%"] = 100 * costs / kernel_ms / maximum;
  state.counters["floor_ms"] = 20.0 * 128 * 127 * 128 * 128 / (2 * maximum);
#endif
}
BENCHMARK(cost_roofline)->Unit(benchmark::kMillisecond)->Iterations(1);

// Figure 3.8: the energy that each width of word reaches, and what it costs in plain code.
void word_widths(benchmark::State& state) {
  const auto problem = wolves(64);
  if (!problem) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  TrwlsOptions options;
  options.width = static_cast<WordWidth>(state.range(0));
  options.instructions = Instructions::plain;
  options.stopping = Stopping::fixed_passes;
  options.polish = Polish::none;
  MatchingSolution solution;
  for (auto _ : state) solution = trwls(*problem, options).value();
  const char* names[] = {"8 bits", "16 bits", "32 bits", "64-bit floating point"};
  state.SetLabel(names[state.range(0)]);
  state.counters["energy"] = solution.energy;
  for (const std::size_t pass : {0, 4, 9, 19}) {
    state.counters[fmt::format("pass_{:02}", pass + 1)] = solution.passes[pass].energy;
  }
}
BENCHMARK(word_widths)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->Iterations(1);

// The energies that 20 passes of the baseline end with. They do not depend on the machine nor on this program's
// arithmetic, and those of 56 pairs of 128 points take minutes: they are kept, each under the content of its problem.
class BaselineEnergies {
 public:
  BaselineEnergies() {
    const char* named = std::getenv("GLISSON_BASELINES");
    file_ = named != nullptr ? named : (glisson::test::build_folder() / "baselines.json").string();
    if (auto known = read_json_file(file_)) known_ = std::move(*known);
  }

  double of(const MatchingProblem& problem) {
    const std::string key = content_hash(problem);
    if (known_.contains(key)) return known_[key].get<double>();
    const double energy = trws(store(problem).value(), {.stopping = Stopping::fixed_passes}).energy;
    known_[key] = energy;
    if (auto written = write_json_file(file_, known_); !written) {
      fmt::print(stderr, "{}\n", written.error().message());
    }
    return energy;
  }

 private:
  static std::string content_hash(const MatchingProblem& problem) {
    std::string bytes;
    const auto add = [&](const double* values, Eigen::Index count) {
      bytes.append(reinterpret_cast<const char*>(values), sizeof(double) * static_cast<std::size_t>(count));
    };
    add(problem.source_mm.data(), problem.source_mm.size());
    add(problem.target_mm.data(), problem.target_mm.size());
    for (const double constant : {problem.sigma_mm, problem.tau_mm, problem.q}) add(&constant, 1);
    return sha256_of_text(bytes);
  }

  std::filesystem::path file_;
  Json known_ = Json::object();
};

// Table 3.1 and 20 registrations a second: n = 128 or 96 on pairs of wolves, cats and livers, dynamic stopping.
void pairs(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const std::vector<std::vector<std::string>> families = {
      {wolf0, wolf1, "tosca_nonrigid_shapes/wolf2.off"},
      {"tosca_nonrigid_shapes/cat0.off", "tosca_nonrigid_shapes/cat1.off", "tosca_nonrigid_shapes/cat2.off"},
      {"pbsm_liver_insilico/Liver1/src.ply", "pbsm_liver_insilico/Liver1/gt.ply"}};
  BaselineEnergies baselines;
  TrwlsOptions as_in_table_3_1;
  as_in_table_3_1.stopping = Stopping::fixed_passes;
  as_in_table_3_1.polish = Polish::none;
  double rough = 0, polished = 0, total_ms = 0, total_cpu_ms = 0, worst_ms = 0, rough_difference = 0, difference = -1;
  int count = 0, close = 0, fast = 0;
  for (auto _ : state) {
    for (const auto& family : families) {
      for (std::size_t i = 0; i < family.size(); ++i) {
        for (std::size_t j = 0; j < family.size(); ++j) {
          if (i == j) continue;
          for (const int start : {0, 500, 1000, 2000}) {
            const GeodesicSamples* a = samples_of(family[i], 0, n);
            const GeodesicSamples* b = samples_of(family[j], start, n);
            if (a == nullptr || b == nullptr) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
            const MatchingProblem problem = problem_of(*a, *b, n);
            const double base = baselines.of(problem);
            const double energy_16 = trwls(problem, as_in_table_3_1).value().energy;
            const double before_ms = cpu_ms();
            const MatchingSolution ours = trwls(problem).value();
            total_cpu_ms += cpu_ms() - before_ms;
            rough += energy_16 / base;
            rough_difference += std::abs(energy_16 / base - 1);
            polished += ours.energy / base;
            difference = std::max(difference, ours.energy / base - 1);
            close += ours.energy / base - 1 <= 0.019 ? 1 : 0;  // table 3.1
            fast += ours.solve_ms <= 50 ? 1 : 0;
            total_ms += ours.solve_ms;
            worst_ms = std::max(worst_ms, ours.solve_ms);
            ++count;
          }
        }
      }
    }
  }
  state.counters["pairs"] = count;
  state.counters["mean_16_bits_%"] = 100 * (rough / count - 1);
  state.counters["mean_abs_16_bits_%"] = 100 * rough_difference / count;
  state.counters["mean_dynamic_%"] = 100 * (polished / count - 1);
  state.counters["worst_dynamic_%"] = 100 * difference;
  state.counters["within_1.9_%"] = 100.0 * close / count;
  state.counters["within_50_ms"] = 100.0 * fast / count;
  state.counters["mean_ms"] = total_ms / count;
  state.counters["mean_cpu_ms"] = total_cpu_ms / count;
  state.counters["worst_ms"] = worst_ms;
}
BENCHMARK(pairs)->ArgName("n")->Arg(64)->Arg(96)->Arg(128)->Unit(benchmark::kSecond)->Iterations(1);

// The curve of correct matches: GEO on shapes whose vertex i is vertex i, 128 points. An error is the geodesic distance
// on the target from where a point was led to where it belongs, over the square root of the area (Kim et al. 2011).
// `at_rest_%` is the best that could be: the two samplings are made apart, so that the nearest sample of the target is
// off by that. A mirrored matching, which distances along the surface cannot tell from the right one, shows as
// orientation_kept below a half.
void correct_matches(benchmark::State& state) {
  const std::pair<const char*, const char*> shapes[] = {{"wolf0", "wolf1"}, {"wolf0", "wolf2"}, {"wolf1", "wolf2"},
                                                        {"cat0", "cat1"},   {"cat0", "cat2"},   {"cat1", "cat2"}};
  const auto& [from, to] = shapes[state.range(0)];
  const auto folder = glisson::test::shared_data() / "tosca_nonrigid_shapes";
  const auto source = geometry::read_surface(folder / fmt::format("{}.off", from));
  const auto target = geometry::read_surface(folder / fmt::format("{}.off", to));
  if (!source || !target) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  SurfaceMatch match;
  for (auto _ : state) match = match_surfaces(*source, *target).value();

  const double size_mm = std::sqrt(geometry::area_mm2(*target));
  const auto& samples = match.target_samples;
  std::vector<double> errors;
  double nearest = 0;
  for (std::size_t i = 0; i < match.source_points.size(); ++i) {
    const auto place = std::find(samples.points.begin(), samples.points.end(), match.target_points[i]);
    const auto row = static_cast<Eigen::Index>(place - samples.points.begin());
    errors.push_back(samples.to_surface_mm(row, match.source_points[i]) / size_mm);
    nearest += samples.to_surface_mm.col(match.source_points[i]).minCoeff() / size_mm;
  }
  const auto count = static_cast<double>(errors.size());
  double sum = 0;
  for (const double error : errors) sum += error;
  state.SetLabel(fmt::format("{} to {}", from, to));
  state.counters["mean_%"] = 100 * sum / count;
  state.counters["at_rest_%"] = 100 * nearest / count;
  for (const double limit : {0.05, 0.1, 0.15, 0.25}) {
    const auto within = std::count_if(errors.begin(), errors.end(), [&](double error) { return error <= limit; });
    state.counters[fmt::format("within_{:02.0f}", 100 * limit)] = 100.0 * static_cast<double>(within) / count;
  }
  state.counters["orientation_kept"] = match.orientation_kept;
  state.counters["solve_ms"] = match.solution.solve_ms;
}
BENCHMARK(correct_matches)->DenseRange(0, 5)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

// GEO as a whole, geodesic distances included, of 128 points of each frame of a breathing liver against a model that
// stays; beside it, each frame matched anew.
void geo_over_a_video(benchmark::State& state) {
  const auto liver = geometry::read_surface(glisson::test::shared_data() / "pbsm_liver_insilico/Liver1/src.ply");
  if (!liver) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  constexpr int frames = 40;
  GeoOptions options;
  options.prior = Prior::positions;
  auto matcher = FrameMatcher::create(*liver, options).value();
  std::vector<double> frame_ms, anew_ms;
  double error_mm = 0, anew_error_mm = 0;
  int searched = 0;
  for (auto _ : state) {
    for (int t = 0; t < frames; ++t) {
      const test::SeenFrame seen = test::breathing_liver(*liver, t, 0.3);
      auto start = Clock::now();
      const SurfaceMatch match = matcher.match(seen.surface).value();
      if (t > 0) frame_ms.push_back(ms_since(start));
      searched += t > 0 && matcher.searched();
      error_mm += test::mean_error_mm(*liver, seen, match.source_points, match.target_points) / frames;
      start = Clock::now();
      const SurfaceMatch anew = match_surfaces(seen.surface, *liver, options).value();
      anew_ms.push_back(ms_since(start));
      anew_error_mm += test::mean_error_mm(*liver, seen, anew.source_points, anew.target_points) / frames;
      state.counters["points"] = static_cast<double>(seen.surface.points_mm.size());
      state.counters["covering_mm"] = match.target_samples.covering_radius_mm;
    }
  }
  const auto median = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
  };
  state.counters["slowest_ms"] = *std::max_element(frame_ms.begin(), frame_ms.end());
  state.counters["frame_ms"] = median(frame_ms);
  state.counters["frames_per_s"] = 1000 / state.counters["frame_ms"];
  state.counters["anew_ms"] = median(anew_ms);
  state.counters["error_mm"] = error_mm;
  state.counters["anew_error_mm"] = anew_error_mm;
  state.counters["searched"] = searched;
}
BENCHMARK(geo_over_a_video)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

// Energy of one registration by each solver, where the machine counts it; n = 96, since the field of 128 takes a while
// to write out.
void energy_a_registration(benchmark::State& state) {
  const auto survey = hardware::survey_meters();
  if (survey.meters.empty() || survey.meters.front().kind != hardware::MeterKind::rapl) {
    return state.SkipWithError("this machine shows no energy counter (RAPL)");
  }
  const auto problem = wolves(96);
  if (!problem) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  const auto& meter = survey.meters.front();
  const int repeats = state.range(0) == 0 ? 1 : 50;
  const auto mrf = state.range(0) == 0 ? store(*problem) : Result<StoredMrf>(StoredMrf{});
  if (!mrf) return state.SkipWithError("the field does not fit in memory");
  double joules = 0;
  for (auto _ : state) {
    const auto use = hardware::energy_during(meter, [&]() -> Result<void> {
      for (int i = 0; i < repeats; ++i) {
        if (state.range(0) == 0) {
          benchmark::DoNotOptimize(trws(*mrf, {.stopping = Stopping::fixed_passes}));
        } else {
          benchmark::DoNotOptimize(trwls(*problem));
        }
      }
      return {};
    });
    if (!use) return state.SkipWithError(use.error().message().c_str());
    joules = use->joules / repeats;
  }
  state.counters["joules"] = joules;
}
BENCHMARK(energy_a_registration)->ArgName("trwls")->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->Iterations(1);

// The dissertation's largest input: 1,155 landmarks, 180 frames; 5 to 12 minutes there.
void sirgn_at_full_size(benchmark::State& state) {
  const auto liver = geometry::read_surface(glisson::test::shared_data() / "pbsm_liver_insilico/Liver1/src.ply");
  if (!liver) return state.SkipWithError("no real data: set GLISSON_SHARED_DATA");
  registration_quality::test::SequenceSpec spec;
  spec.frames = 180;
  spec.landmarks = 1155;
  const auto made = registration_quality::test::make_sequence(*liver, spec);
  for (auto _ : state) benchmark::DoNotOptimize(registration_quality::sirgn(made.sequence));
}
BENCHMARK(sirgn_at_full_size)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace glisson::registration

BENCHMARK_MAIN();
