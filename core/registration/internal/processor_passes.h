#pragma once
// Passes of messages on this machine's processors: all threads, in the order of the schedule.

#include <chrono>
#include <cmath>
#include <thread>

#include "base/parallel.h"
#include "base/progress.h"
#include "registration/internal/quantised_field.h"
#include "registration/internal/trwls_schedule.h"

namespace glisson::registration {

// Without a division for 32 bits, which has no vectors. A reciprocal that is rounded down gives at most one too few.
inline std::uint64_t quotient_of(std::uint64_t whole, std::uint64_t divisor) { return whole / divisor; }
inline std::uint32_t quotient_of(std::uint32_t whole, std::uint32_t divisor) {
  const auto quotient = static_cast<std::uint32_t>((whole * ((std::uint64_t{1} << 32) / divisor)) >> 32);
  return quotient + (whole - quotient * divisor >= divisor ? 1 : 0);
}

enum class Direction { forth, back };
inline Direction direction_of(int sweep) { return sweep % 2 == 0 ? Direction::forth : Direction::back; }

// Helpers wait longest while a pass's labelling is read and polished, a tenth of a pass. Half a pass is waited for, and
// a little more where passes are short. A cost takes about 0.02 ns in vectors.
inline std::chrono::microseconds patience(const MatchingProblem& problem) {
  const double costs = std::pow(problem.nodes(), 2) * std::pow(problem.labels(), 2);
  return std::chrono::microseconds(2000 + std::llround(0.5 * 2e-5 * costs));
}

template <typename Word>
class ProcessorPasses {
 public:
  using Total = typename Arithmetic<Word>::Total;
  using Bound = typename Arithmetic<Word>::Bound;

  ProcessorPasses(const MatchingProblem& problem, const TrwlsOptions& options, const Quantised<Word>& field,
                  const SliceKernels<Word>& kernels)
      : kernels_(kernels),
        field_(field),
        nodes_(problem.nodes()),
        stride_(static_cast<std::size_t>(field_.slices.stride)),
        schedule_(nodes_, 2 * options.passes, patience(problem), options.order),
        messages_(count() * messages_to_one_node()),
        shares_(count() * stride_),
        one_more_from_(count() * stride_, never_one_more),
        totals_(count() * stride_),
        scratch_(4 * stride_) {
    for (auto& bounds : node_bounds_) bounds.resize(count());
    for (auto& bounds : chunk_bounds_) bounds.resize(schedule_.chunks());
    constexpr int fewest_nodes_worth_a_thread = 24;
    for (int thread = 1; thread < thread_count() && nodes_ >= fewest_nodes_worth_a_thread; ++thread) {
      helpers_.emplace_back([this] { help(); });
    }
    claim_ = schedule_.claim();
  }
  ~ProcessorPasses() { schedule_.call_off(); }
  ProcessorPasses(const ProcessorPasses&) = delete;
  ProcessorPasses& operator=(const ProcessorPasses&) = delete;

  // Once forth and once back. Fails where it is cancelled in the midst of a pass, of which nothing is kept then.
  Result<void> pass(int number, const Progress& progress) {
    const int last_sweep = 2 * number + 1;
    for (; claim_.sweep <= last_sweep && !progress.cancelled(); claim_ = schedule_.claim()) send(claim_, scratch_);
    if (claim_.sweep <= last_sweep) return cancelled();
    schedule_.wait_for_belief(last_sweep, nodes_ - 1, [this](int s, int p) { gather(s, p); });
    return {};
  }

  // costs[l] += the messages to node s from the nodes after it.
  void add_later_messages(int s, Total* costs) const {
    if (s + 1 < nodes_) kernels_.add_messages(field_.slices, message(s + 1, s), nodes_ - 1 - s, costs);
  }

  // In words: what this pass's last sweep took off beliefs and messages.
  [[nodiscard]] double taken(int number) const {
    const int sweep = 2 * number + 1;
    Bound taken = 0;
    for (const Bound bound : node_bounds_[sweep % 2]) taken += bound;
    for (const Bound bound : chunk_bounds_[sweep % 2]) taken += bound;
    return static_cast<double>(taken);
  }

  // The messages of a pass are needed no more.
  void labelling_was_read(int number) { schedule_.labelling_was_read(number + 1); }

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
  bool send(const Schedule::Claim& claim, AlignedVector<Word>& scratch);
  void gather(int sweep, int position);
  void share_belief(const Total* belief, Total minimum, int node, Word* share, std::uint16_t* one_more_from) const;

  SliceKernels<Word> kernels_;
  const Quantised<Word>& field_;
  int nodes_;
  std::size_t stride_;
  Schedule schedule_;
  AlignedVector<Word> messages_;
  AlignedVector<Word> shares_;  // of beliefs; by position, as the next two
  AlignedVector<std::uint16_t> one_more_from_;
  AlignedVector<Total> totals_;  // each gathering has its own
  AlignedVector<Word> scratch_;  // this thread's
  // What was taken off beliefs and messages, in sweeps forth and in sweeps back.
  std::vector<Bound> node_bounds_[2];
  std::vector<Bound> chunk_bounds_[2];
  Schedule::Claim claim_;
  std::vector<std::jthread> helpers_;  // the first to go
};

template <typename Word>
void ProcessorPasses<Word>::help() {
  AlignedVector<Word> scratch(4 * stride_);
  while (schedule_.helpers_stay()) {
    const auto claim = schedule_.claim();
    if (claim.sweep >= schedule_.sweeps() || !send(claim, scratch)) return;
  }
}

// Sends the messages of one chunk. False when everything was called off.
template <typename Word>
bool ProcessorPasses<Word>::send(const Schedule::Claim& claim, AlignedVector<Word>& scratch) {
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
void ProcessorPasses<Word>::gather(int sweep, int position) {
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

// gamma (belief - minimum), so that all chains through the node together get what there is. A division in whole numbers
// leaves something over, which goes in ones to the last of them. Cut at twice the largest cost; so is the padding.
template <typename Word>
void ProcessorPasses<Word>::share_belief(const Total* belief, Total minimum, int node, Word* share,
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

}  // namespace glisson::registration
