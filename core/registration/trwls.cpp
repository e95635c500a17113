#include "registration/trwls.h"

#include <chrono>
#include <cmath>

#include "base/parallel.h"
#include "registration/internal/rough_starts.h"
#include "registration/internal/trwls_plain.h"
#include "registration/internal/trwls_schedule.h"
#include "registration/internal/trwls_simd.h"

namespace glisson::registration {
namespace {

template <typename Word>
MatchingSolution solve(const MatchingProblem& problem, const TrwlsOptions& options, const SliceKernels<Word>& kernels,
                       const Progress& progress);

// Of work that was cancelled before its first pass.
MatchingSolution unsolved(const MatchingProblem& problem, const MatchingEnergy& energy);

}  // namespace

Result<MatchingSolution> trwls(const MatchingProblem& problem, const TrwlsOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (auto good = check(problem); !good) return failure(good.error());
  GLISSON_ASSERT(options.passes >= 1);
  if (progress.cancelled()) return unsolved(problem, MatchingEnergy(problem));
  const bool plain = options.instructions == Instructions::plain;
  MatchingSolution solution;
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
  solution.solve_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return solution;
}

const char* widest_instructions() { return simd_name(); }

namespace {

// Without a division for 32 bits, which has no vectors. A reciprocal that is rounded down gives at most one too few.
std::uint64_t quotient_of(std::uint64_t whole, std::uint64_t divisor) { return whole / divisor; }
std::uint32_t quotient_of(std::uint32_t whole, std::uint32_t divisor) {
  const auto quotient = static_cast<std::uint32_t>((whole * ((std::uint64_t{1} << 32) / divisor)) >> 32);
  return quotient + (whole - quotient * divisor >= divisor ? 1 : 0);
}

constexpr int words_in_widest_vector = 64;  // of 8 bits; arrays are padded to it

enum class Direction { forth, back };
Direction direction_of(int sweep) { return sweep % 2 == 0 ? Direction::forth : Direction::back; }

// The field in words, and how to come back from them to energies.
template <typename Word>
struct Quantised {
  using Total = typename Arithmetic<Word>::Total;

  Slices<Word> slices;
  AlignedVector<Total> seed;             // seed[node * stride + label], less each node's minimum
  double minimum_seeds = 0;              // the sum of what was taken off
  double energy_of_one = 0;              // the energy that a cost of 1 stands for
  double maximum_added_by_rounding = 0;  // no labelling costs more in words than its energy and this
};

template <typename Word>
Quantised<Word> quantise(const MatchingProblem& problem);

// Helpers wait longest while a pass's labelling is read and polished, a tenth of a pass; half a pass is waited for, and
// a little more where passes are short. A cost takes about 0.02 ns in vectors.
std::chrono::microseconds patience(const MatchingProblem& problem) {
  const double costs = std::pow(problem.nodes(), 2) * std::pow(problem.labels(), 2);
  return std::chrono::microseconds(2000 + std::llround(0.5 * 2e-5 * costs));
}

template <typename Word>
class Trwls {
 public:
  using Total = typename Arithmetic<Word>::Total;
  using Bound = typename Arithmetic<Word>::Bound;

  Trwls(const MatchingProblem& problem, const TrwlsOptions& options, const SliceKernels<Word>& kernels)
      : problem_(problem),
        options_(options),
        kernels_(kernels),
        field_(quantise<Word>(problem)),
        energy_(problem),
        nodes_(problem.nodes()),
        stride_(static_cast<std::size_t>(field_.slices.stride)),
        schedule_(nodes_, 2 * options.passes, patience(problem), options.order),
        messages_(count() * messages_to_one_node()),
        shares_(count() * stride_),
        one_more_from_(count() * stride_, never_one_more),
        totals_(count() * stride_) {
    for (auto& bounds : node_bounds_) bounds.resize(count());
    for (auto& bounds : chunk_bounds_) bounds.resize(schedule_.chunks());
  }

  MatchingSolution run(const Progress& progress);

 private:
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(nodes_); }
  [[nodiscard]] int node_at(int position, Direction direction) const {
    return direction == Direction::forth ? position : nodes_ - 1 - position;
  }
  // The message from node s to node t. All messages to one node lie one after the other. Between nodes lies a little
  // more, lest the messages from one node fall into the same few places of the cache.
  [[nodiscard]] std::size_t message_index(int s, int t) const {
    return static_cast<std::size_t>(t) * messages_to_one_node() + static_cast<std::size_t>(s) * stride_;
  }
  [[nodiscard]] Word* message(int s, int t) { return messages_.data() + message_index(s, t); }
  [[nodiscard]] const Word* message(int s, int t) const { return messages_.data() + message_index(s, t); }
  [[nodiscard]] std::size_t messages_to_one_node() const { return count() * stride_ + words_in_widest_vector; }

  void help();
  void add_cost_of_neighbour(int s, int t, int label_of_t, Total* costs) const;
  bool send(const Schedule::Claim& claim, AlignedVector<Word>& scratch);
  void gather(int sweep, int position);
  void share_belief(const Total* belief, Total minimum, int node, Word* share, std::uint16_t* one_more_from) const;
  [[nodiscard]] double lower_bound(int sweep) const;
  [[nodiscard]] Labelling labelling() const;
  void polish(Labelling& labels, const Progress& progress) const;
  void try_other_starts(MatchingSolution& solution, const Progress& progress) const;
  [[nodiscard]] int cheapest(const AlignedVector<Total>& costs) const;

  const MatchingProblem& problem_;
  const TrwlsOptions& options_;
  SliceKernels<Word> kernels_;
  Quantised<Word> field_;
  MatchingEnergy energy_;
  int nodes_;
  std::size_t stride_;
  Schedule schedule_;
  AlignedVector<Word> messages_;
  AlignedVector<Word> shares_;  // of beliefs; by position, as the next two
  AlignedVector<std::uint16_t> one_more_from_;
  AlignedVector<Total> totals_;  // each gathering has its own
  // What was taken off beliefs and messages, in sweeps forth and in sweeps back.
  std::vector<Bound> node_bounds_[2];
  std::vector<Bound> chunk_bounds_[2];
};

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

template <typename Word>
MatchingSolution solve(const MatchingProblem& problem, const TrwlsOptions& options, const SliceKernels<Word>& kernels,
                       const Progress& progress) {
  return Trwls<Word>(problem, options, kernels).run(progress);
}

template <typename Word>
MatchingSolution Trwls<Word>::run(const Progress& progress) {
  constexpr int fewest_nodes_worth_a_thread = 24;
  std::vector<std::jthread> helpers;
  for (int thread = 1; thread < thread_count() && nodes_ >= fewest_nodes_worth_a_thread; ++thread) {
    helpers.emplace_back([this] { help(); });
  }

  MatchingSolution solution;
  solution.energy = std::numeric_limits<double>::infinity();
  solution.lower_bound = -std::numeric_limits<double>::infinity();
  AlignedVector<Word> scratch(4 * stride_);
  Schedule::Claim claim = schedule_.claim();
  while (solution.stopped == StopReason::not_run) {
    const int pass = static_cast<int>(solution.passes.size());
    const int last_sweep = 2 * pass + 1;
    for (; claim.sweep <= last_sweep && !progress.cancelled(); claim = schedule_.claim()) send(claim, scratch);
    if (claim.sweep <= last_sweep) {  // in the midst of a pass, of which nothing is kept
      solution.stopped = StopReason::cancelled;
      break;
    }
    schedule_.wait_for_belief(last_sweep, nodes_ - 1, [this](int s, int p) { gather(s, p); });

    Labelling labels = labelling();
    if (options_.polish == Polish::single_nodes) polish(labels, progress);
    const SolverPass outcome{energy_(labels), lower_bound(last_sweep)};
    schedule_.labelling_was_read(pass + 1);
    solution.passes.push_back(outcome);
    solution.lower_bound = std::max(solution.lower_bound, outcome.lower_bound);
    if (outcome.energy < solution.energy) {
      solution.energy = outcome.energy;
      solution.labels = std::move(labels);
    }
    solution.stopped = progress.cancelled() ? StopReason::cancelled : reason_to_stop(solution.passes, options_);
    progress.report(static_cast<double>(pass + 1) / options_.passes, GLISSON_TEXT("matching"));
  }
  schedule_.call_off();
  helpers.clear();
  const bool may_be_better = solution.stopped != StopReason::cancelled && solution.stopped != StopReason::bound_met;
  const bool wanted = options_.starts == Starts::several && options_.polish == Polish::single_nodes &&
                      options_.stopping == Stopping::dynamic;
  if (wanted && may_be_better) try_other_starts(solution, progress);
  if (solution.labels.empty()) return unsolved(problem_, energy_);
  return solution;
}

template <typename Word>
void Trwls<Word>::help() {
  AlignedVector<Word> scratch(4 * stride_);
  while (schedule_.helpers_stay()) {
    const auto claim = schedule_.claim();
    if (claim.sweep >= schedule_.sweeps() || !send(claim, scratch)) return;
  }
}

// Sends the messages of one chunk. False when everything was called off.
template <typename Word>
bool Trwls<Word>::send(const Schedule::Claim& claim, AlignedVector<Word>& scratch) {
  const auto gather_when_due = [this](int sweep, int position) { gather(sweep, position); };
  const Chunk& chunk = schedule_.chunk(claim.chunk);
  if (!schedule_.wait_for_belief(claim.sweep, chunk.position, gather_when_due)) return false;

  const Direction direction = direction_of(claim.sweep);
  const int s = node_at(chunk.position, direction);
  std::vector<Message<Word>> messages;
  messages.reserve(static_cast<std::size_t>(chunk.targets));
  for (int target = chunk.first_target; target < chunk.first_target + chunk.targets; ++target) {
    const int t = node_at(target, direction);
    const std::size_t pair = field_.slices.pair_of_nodes(s, t);
    messages.push_back({message(t, s), message(s, t), field_.slices.x[pair], field_.slices.x_weight[pair],
                        target - chunk.position - 1});
  }
  const std::size_t place = static_cast<std::size_t>(chunk.position) * stride_;
  const SharedBelief<Word> belief{shares_.data() + place, one_more_from_.data() + place};
  chunk_bounds_[claim.sweep % 2][claim.chunk] =
      kernels_.send(field_.slices, belief, messages.data(), chunk.targets, scratch.data());
  schedule_.finished(claim);
  schedule_.gather_next(gather_when_due);
  return true;
}

template <typename Word>
void Trwls<Word>::gather(int sweep, int position) {
  const int s = node_at(position, direction_of(sweep));
  const std::size_t place = static_cast<std::size_t>(position) * stride_;
  Total* belief = totals_.data() + place;
  const Total* seed = field_.seed.data() + static_cast<std::size_t>(s) * stride_;
  std::copy(seed, seed + stride_, belief);
  kernels_.add_messages(field_.slices, message(0, s), nodes_, belief);  // the node's message to itself stays 0

  const Total minimum = *std::min_element(belief, belief + field_.slices.labels);
  share_belief(belief, minimum, s, shares_.data() + place, one_more_from_.data() + place);
  node_bounds_[sweep % 2][static_cast<std::size_t>(position)] = static_cast<Bound>(minimum);
}

// gamma (belief - minimum), so that all chains through the node together get what there is: what a division in whole
// numbers leaves over goes in ones to the last of them. Cut at twice the largest cost; so is the padding.
template <typename Word>
void Trwls<Word>::share_belief(const Total* belief, Total minimum, int node, Word* share,
                               std::uint16_t* one_more_from) const {
  const auto maximum = static_cast<Word>(2 * field_.slices.largest_cost);
  const int labels = field_.slices.labels;
  const int chains = std::max(node, nodes_ - 1 - node);
  if constexpr (std::is_integral_v<Word>) {
    const auto divisor = static_cast<Total>(chains);
    for (int k = 0; k < labels; ++k) {
      const Total whole = belief[k] - minimum;
      const Total quotient = quotient_of(whole, divisor);
      const bool is_cut = quotient >= maximum;
      share[k] = is_cut ? maximum : static_cast<Word>(quotient);
      one_more_from[k] = is_cut ? never_one_more : static_cast<std::uint16_t>(divisor - (whole - quotient * divisor));
    }
  } else {
    for (int k = 0; k < labels; ++k) share[k] = std::min((belief[k] - minimum) / static_cast<Total>(chains), maximum);
  }
  std::fill(share + labels, share + stride_, maximum);
}

template <typename Word>
double Trwls<Word>::lower_bound(int sweep) const {
  Bound taken = 0;
  for (const Bound bound : node_bounds_[sweep % 2]) taken += bound;
  for (const Bound bound : chunk_bounds_[sweep % 2]) taken += bound;
  return field_.minimum_seeds + static_cast<double>(taken) * field_.energy_of_one - field_.maximum_added_by_rounding;
}

// As in `trws`: node by node, given the labels fixed before it and the messages from the nodes after it.
template <typename Word>
Labelling Trwls<Word>::labelling() const {
  Labelling labels(count());
  AlignedVector<Total> costs(stride_);
  for (int s = 0; s < nodes_; ++s) {
    const Total* seed = field_.seed.data() + static_cast<std::size_t>(s) * stride_;
    std::copy(seed, seed + stride_, costs.begin());
    for (int t = 0; t < s; ++t) add_cost_of_neighbour(s, t, labels[static_cast<std::size_t>(t)], costs.data());
    if (s + 1 < nodes_) kernels_.add_messages(field_.slices, message(s + 1, s), nodes_ - 1 - s, costs.data());
    labels[static_cast<std::size_t>(s)] = cheapest(costs);
  }
  return labels;
}

template <typename Word>
void Trwls<Word>::polish(Labelling& labels, const Progress& progress) const {
  constexpr int maximum_rounds = 20;
  AlignedVector<Total> costs(stride_);
  int settled = 0;  // nodes in a row that kept their labels
  for (int visit = 0; visit < maximum_rounds * nodes_ && settled < nodes_ && !progress.cancelled(); ++visit) {
    const int s = visit % nodes_;
    int& label = labels[static_cast<std::size_t>(s)];
    const Total* seed = field_.seed.data() + static_cast<std::size_t>(s) * stride_;
    std::copy(seed, seed + stride_, costs.begin());
    for (int t = 0; t < nodes_; ++t) {
      if (t != s) add_cost_of_neighbour(s, t, labels[static_cast<std::size_t>(t)], costs.data());
    }
    const int best = cheapest(costs);
    const bool better = costs[static_cast<std::size_t>(best)] < costs[static_cast<std::size_t>(label)];
    settled = better ? 0 : settled + 1;
    if (better) label = best;
  }
}

// Each start gives the other nodes the labels that go best with it, and is polished.
template <typename Word>
void Trwls<Word>::try_other_starts(MatchingSolution& solution, const Progress& progress) const {
  const std::vector<RoughStart> starts = rough_starts(problem_);
  std::vector<Labelling> settled(starts.size());
  parallel_for(starts.size(), 1, [&](std::size_t begin, std::size_t end) {
    AlignedVector<Total> costs(stride_);
    for (std::size_t k = begin; k < end; ++k) {
      const RoughStart& start = starts[k];
      Labelling& labels = settled[k];
      for (int s = 0; s < nodes_ && !progress.cancelled(); ++s) {
        std::copy_n(field_.seed.data() + static_cast<std::size_t>(s) * stride_, stride_, costs.begin());
        for (std::size_t i = 0; i < start.nodes.size(); ++i) {
          if (start.nodes[i] != s) add_cost_of_neighbour(s, start.nodes[i], start.labels[i], costs.data());
        }
        labels.push_back(cheapest(costs));
      }
      polish(labels, progress);
    }
  });
  if (progress.cancelled()) solution.stopped = StopReason::cancelled;
  for (Labelling& labels : settled) {
    if (labels.size() != count()) continue;  // cancelled
    const double energy = energy_(labels);
    if (energy >= solution.energy) continue;
    solution.energy = energy;
    solution.labels = std::move(labels);
  }
}

template <typename Word>
void Trwls<Word>::add_cost_of_neighbour(int s, int t, int label_of_t, Total* costs) const {
  const std::size_t pair = field_.slices.pair_of_nodes(t, s);
  kernels_.add_costs(field_.slices, field_.slices.x[pair], field_.slices.x_weight[pair], label_of_t, costs);
}

template <typename Word>
int Trwls<Word>::cheapest(const AlignedVector<Total>& costs) const {
  return static_cast<int>(std::min_element(costs.begin(), costs.begin() + field_.slices.labels) - costs.begin());
}

template <typename Word>
Quantised<Word> quantise(const MatchingProblem& problem) {
  using Number = Arithmetic<Word>;
  constexpr bool fixed_point = std::is_integral_v<Word>;
  const int nodes = problem.nodes();
  const int labels = problem.labels();
  Quantised<Word> field;
  Slices<Word>& slices = field.slices;
  slices.nodes = nodes;
  slices.labels = labels;
  slices.stride = (labels + words_in_widest_vector - 1) / words_in_widest_vector * words_in_widest_vector;

  // The finest step at which the largest cost fits, and tau beside the largest distance.
  double steps_per_mm = 1;
  if constexpr (fixed_point) {
    const double largest_mm = std::max(problem.source_mm.maxCoeff(), problem.target_mm.maxCoeff());
    steps_per_mm =
        std::min(Number::largest_cost / problem.tau_mm, (Number::largest_word - 1.0) / (largest_mm + problem.tau_mm));
  }
  const auto in_steps = [&](double distance_mm) {
    const double steps = distance_mm * steps_per_mm;
    return static_cast<Word>(fixed_point ? std::round(steps) : steps);
  };
  const auto in_weights = [&](double distance_mm) {
    const double weight = Number::weight_of_one * std::exp(-distance_mm / problem.sigma_mm);
    return static_cast<Word>(fixed_point ? std::floor(weight) : weight);
  };
  const double tau_steps = problem.tau_mm * steps_per_mm;
  slices.tau =
      static_cast<Word>(fixed_point ? std::floor(std::min<double>(tau_steps, Number::largest_word)) : tau_steps);
  slices.largest_cost = slices.tau;

  slices.x.resize(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes));
  slices.x_weight.resize(slices.x.size());
  for (int s = 0; s < nodes; ++s) {
    for (int t = 0; t < nodes; ++t) {
      slices.x[slices.pair_of_nodes(s, t)] = in_steps(problem.source_mm(s, t));
      slices.x_weight[slices.pair_of_nodes(s, t)] = in_weights(problem.source_mm(s, t));
    }
  }
  slices.y.resize(static_cast<std::size_t>(labels) * static_cast<std::size_t>(slices.stride));
  slices.y_weight.resize(slices.y.size());
  for (int k = 0; k < labels; ++k) {
    for (int l = 0; l < labels; ++l) {
      slices.y[slices.row(k) + static_cast<std::size_t>(l)] = in_steps(problem.target_mm(k, l));
      slices.y_weight[slices.row(k) + static_cast<std::size_t>(l)] = in_weights(problem.target_mm(k, l));
    }
  }

  field.energy_of_one = problem.q / (steps_per_mm * Number::cost_of_one);
  // Two distances rounded to the nearest step differ by at most one step more than the true ones; weights, tau and
  // products are rounded down.
  field.maximum_added_by_rounding =
      fixed_point ? static_cast<double>(problem.pairs_of_nodes()) * problem.q / steps_per_mm : 0.0;

  field.seed.resize(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(slices.stride));
  if (problem.seed.size() > 0) {
    // A label that costs more than its node's cheapest by all that its pairs can cost never wins: cut there.
    const double maximum = static_cast<double>(nodes) * static_cast<double>(slices.largest_cost);
    for (int s = 0; s < nodes; ++s) {
      const double minimum = problem.seed.row(s).minCoeff();
      field.minimum_seeds += minimum;
      for (int l = 0; l < labels; ++l) {
        const double cost = std::min((problem.seed(s, l) - minimum) / field.energy_of_one, maximum);
        field
            .seed[static_cast<std::size_t>(s) * static_cast<std::size_t>(slices.stride) + static_cast<std::size_t>(l)] =
            static_cast<typename Number::Total>(cost);
      }
    }
  }
  return field;
}

}  // namespace
}  // namespace glisson::registration
