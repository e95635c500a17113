#include "registration/trwls.h"

#include <chrono>

#include "registration/internal/device_passes.h"
#include "registration/internal/labelling.h"
#include "registration/internal/processor_passes.h"
#include "registration/internal/trwls_plain.h"
#include "registration/internal/trwls_simd.h"

namespace glisson::registration {
namespace {

template <typename Word>
Result<MatchingSolution> solve(const MatchingProblem& problem, const TrwlsOptions& options,
                               const SliceKernels<Word>& kernels, const Progress& progress);

// Of work that was cancelled before its first pass.
MatchingSolution unsolved(const MatchingProblem& problem, const MatchingEnergy& energy);

}  // namespace

Result<MatchingSolution> trwls(const MatchingProblem& problem, const TrwlsOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (auto good = check(problem); !good) return failure(good.error());
  GLISSON_ASSERT(options.passes >= 1 && (!options.device || options.width == WordWidth::bits_16));
  if (progress.cancelled()) return unsolved(problem, MatchingEnergy(problem));
  const bool plain = options.instructions == Instructions::plain;
  Result<MatchingSolution> solution;
  switch (options.width) {
    case WordWidth::bits_8:
      solution = solve<std::uint8_t>(problem, options, PlainKernels<std::uint8_t>::table(), progress);
      break;
    case WordWidth::bits_16:
      solution = solve<std::uint16_t>(problem, options, plain ? PlainKernels<std::uint16_t>::table() : simd_kernels(),
                                      progress);
      break;
    case WordWidth::bits_32:
      solution = solve<std::uint32_t>(problem, options, PlainKernels<std::uint32_t>::table(), progress);
      break;
    case WordWidth::double_precision:
      solution = solve<double>(problem, options, PlainKernels<double>::table(), progress);
      break;
  }
  if (!solution) return solution;
  solution->solve_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return solution;
}

const char* widest_instructions() { return simd_name(); }

namespace {

// The passes, whoever does them, and after each the labels that it found.
template <typename Word, typename Passes>
Result<MatchingSolution> solve_by(Passes& passes, const TrwlsOptions& options, const Quantised<Word>& field,
                                  const Labeller<Word>& labeller, const MatchingEnergy& energy,
                                  const Progress& progress) {
  MatchingSolution solution;
  solution.energy = std::numeric_limits<double>::infinity();
  solution.lower_bound = -std::numeric_limits<double>::infinity();
  for (int pass = 0; solution.stopped == StopReason::not_run; ++pass) {
    if (auto passed = passes.pass(pass, progress); !passed) {
      if (!progress.cancelled()) return failure(passed.error());
      solution.stopped = StopReason::cancelled;
      break;
    }
    Labelling labels = labeller.from_messages([&](int s, auto* costs) { passes.add_later_messages(s, costs); });
    if (options.polish == Polish::single_nodes) labeller.polish(labels, progress);
    const double bound =
        field.minimum_seeds + passes.taken(pass) * field.energy_of_one - field.maximum_added_by_rounding;
    const SolverPass outcome{energy(labels), bound};
    passes.labelling_was_read(pass);
    solution.passes.push_back(outcome);
    solution.lower_bound = std::max(solution.lower_bound, outcome.lower_bound);
    if (outcome.energy < solution.energy) {
      solution.energy = outcome.energy;
      solution.labels = std::move(labels);
    }
    solution.stopped = progress.cancelled() ? StopReason::cancelled : reason_to_stop(solution.passes, options);
    progress.report(static_cast<double>(pass + 1) / options.passes, GLISSON_TEXT("matching"));
  }
  return solution;
}

template <typename Word>
void try_other_starts(const MatchingProblem& problem, const Labeller<Word>& labeller, const MatchingEnergy& energy,
                      MatchingSolution& solution, const Progress& progress) {
  std::vector<Labelling> settled = labeller.from_starts(rough_starts(problem), progress);
  if (progress.cancelled()) solution.stopped = StopReason::cancelled;
  for (Labelling& labels : settled) {
    if (labels.size() != static_cast<std::size_t>(problem.nodes())) continue;  // cancelled
    const double cost = energy(labels);
    if (cost >= solution.energy) continue;
    solution.energy = cost;
    solution.labels = std::move(labels);
  }
}

template <typename Word>
Result<MatchingSolution> solve(const MatchingProblem& problem, const TrwlsOptions& options,
                               const SliceKernels<Word>& kernels, const Progress& progress) {
  const Quantised<Word> field = quantise<Word>(problem);
  const Labeller<Word> labeller(field, kernels);
  const MatchingEnergy energy(problem);
  Result<MatchingSolution> solution;
  if constexpr (std::is_same_v<Word, std::uint16_t>) {
    if (options.device) {
      auto passes = DevicePasses::open(field, *options.device);
      if (!passes) return failure(passes.error());
      solution = solve_by(*passes, options, field, labeller, energy, progress);
    }
  }
  if (!options.device) {
    ProcessorPasses<Word> passes(problem, options, field, kernels);
    solution = solve_by(passes, options, field, labeller, energy, progress);
  }
  if (!solution) return solution;
  const bool may_be_better = solution->stopped != StopReason::cancelled && solution->stopped != StopReason::bound_met;
  const bool wanted = options.starts == Starts::several && options.polish == Polish::single_nodes &&
                      options.stopping == Stopping::dynamic;
  if (wanted && may_be_better) try_other_starts(problem, labeller, energy, *solution, progress);
  if (solution->labels.empty()) return unsolved(problem, energy);
  return solution;
}

// Each node's cheapest seed, as if there were no pairs. No energy is less than what the seeds cost at least.
MatchingSolution unsolved(const MatchingProblem& problem, const MatchingEnergy& energy) {
  MatchingSolution solution;
  solution.stopped = StopReason::cancelled;
  for (int s = 0; s < problem.nodes(); ++s) {
    Eigen::Index label = 0;
    if (problem.seed.size() > 0) solution.lower_bound += problem.seed.row(s).minCoeff(&label);
    solution.labels.push_back(static_cast<int>(label));
  }
  solution.energy = energy(solution.labels);
  return solution;
}

}  // namespace
}  // namespace glisson::registration
