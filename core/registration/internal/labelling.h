#pragma once
// Labels read from messages, and made better one node at a time. It knows the field, not who passed the messages.

#include <algorithm>

#include "base/parallel.h"
#include "base/progress.h"
#include "registration/internal/quantised_field.h"
#include "registration/internal/rough_starts.h"

namespace glisson::registration {

template <typename Word>
class Labeller {
 public:
  using Total = typename Arithmetic<Word>::Total;

  Labeller(const Quantised<Word>& field, const SliceKernels<Word>& kernels)
      : field_(field), kernels_(kernels), nodes_(field.slices.nodes), stride_(field.slices.stride) {}

  // As in `trws`: node by node, given the labels fixed before it and the messages from the nodes after it, whose sum
  // add_later_messages(node, costs) adds.
  template <typename AddLaterMessages>
  [[nodiscard]] Labelling from_messages(const AddLaterMessages& add_later_messages) const {
    Labelling labels(static_cast<std::size_t>(nodes_));
    AlignedVector<Total> costs(stride_);
    for (int s = 0; s < nodes_; ++s) {
      begin_with_seed(s, costs);
      for (int t = 0; t < s; ++t) add_cost_of_neighbour(s, t, labels[static_cast<std::size_t>(t)], costs);
      add_later_messages(s, costs.data());
      labels[static_cast<std::size_t>(s)] = cheapest(costs);
    }
    return labels;
  }

  // One node at a time takes the label that is cheapest given all others, until none changes.
  void polish(Labelling& labels, const Progress& progress) const {
    constexpr int maximum_rounds = 20;
    AlignedVector<Total> costs(stride_);
    int settled = 0;  // nodes in a row that kept their labels
    for (int visit = 0; visit < maximum_rounds * nodes_ && settled < nodes_ && !progress.cancelled(); ++visit) {
      const int s = visit % nodes_;
      int& label = labels[static_cast<std::size_t>(s)];
      begin_with_seed(s, costs);
      for (int t = 0; t < nodes_; ++t) {
        if (t != s) add_cost_of_neighbour(s, t, labels[static_cast<std::size_t>(t)], costs);
      }
      const int best = cheapest(costs);
      const bool better = costs[static_cast<std::size_t>(best)] < costs[static_cast<std::size_t>(label)];
      settled = better ? 0 : settled + 1;
      if (better) label = best;
    }
  }

  // Each start gives the other nodes the labels that go best with it, and is polished. Cancelled ones are shorter.
  [[nodiscard]] std::vector<Labelling> from_starts(const std::vector<RoughStart>& starts,
                                                   const Progress& progress) const {
    std::vector<Labelling> settled(starts.size());
    parallel_for(starts.size(), 1, [&](std::size_t begin, std::size_t end) {
      AlignedVector<Total> costs(stride_);
      for (std::size_t k = begin; k < end; ++k) {
        const RoughStart& start = starts[k];
        for (int s = 0; s < nodes_ && !progress.cancelled(); ++s) {
          begin_with_seed(s, costs);
          for (std::size_t i = 0; i < start.nodes.size(); ++i) {
            if (start.nodes[i] != s) add_cost_of_neighbour(s, start.nodes[i], start.labels[i], costs);
          }
          settled[k].push_back(cheapest(costs));
        }
        polish(settled[k], progress);
      }
    });
    return settled;
  }

 private:
  void begin_with_seed(int s, AlignedVector<Total>& costs) const {
    std::copy_n(field_.seed.data() + static_cast<std::size_t>(s) * stride_, stride_, costs.begin());
  }
  void add_cost_of_neighbour(int s, int t, int label_of_t, AlignedVector<Total>& costs) const {
    const std::size_t pair = field_.slices.pair_of_nodes(t, s);
    kernels_.add_costs(field_.slices, field_.slices.x[pair], field_.slices.x_weight[pair], label_of_t, costs.data());
  }
  [[nodiscard]] int cheapest(const AlignedVector<Total>& costs) const {
    return static_cast<int>(std::min_element(costs.begin(), costs.begin() + field_.slices.labels) - costs.begin());
  }

  const Quantised<Word>& field_;
  SliceKernels<Word> kernels_;
  int nodes_;
  std::size_t stride_;
};

}  // namespace glisson::registration
