#include "registration/trws.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace glisson::registration {
namespace {

enum class Sweep { forth, back };

class Trws {
 public:
  explicit Trws(const StoredMrf& mrf)
      : mrf_(mrf),
        nodes_(mrf.nodes),
        labels_(mrf.labels),
        messages_(static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_) *
                  static_cast<std::size_t>(labels_)),
        belief_(static_cast<std::size_t>(labels_)),
        offset_(static_cast<std::size_t>(labels_)) {}

  double sweep(Sweep direction);
  [[nodiscard]] Labelling labelling() const;

 private:
  // The message from node s to node t, over the labels of t.
  double* message(int s, int t) { return messages_.data() + message_index(s, t); }
  [[nodiscard]] const double* message(int s, int t) const { return messages_.data() + message_index(s, t); }
  [[nodiscard]] std::size_t message_index(int s, int t) const {
    return (static_cast<std::size_t>(t) * static_cast<std::size_t>(nodes_) + static_cast<std::size_t>(s)) *
           static_cast<std::size_t>(labels_);
  }
  double gather_belief(int s);
  double update_message(int s, int t, double gamma);

  const StoredMrf& mrf_;
  int nodes_;
  int labels_;
  std::vector<double> messages_;
  std::vector<double> belief_;  // of the node being visited
  std::vector<double> offset_;
};

double take_minimum_off(double* values, int count) {
  const double minimum = *std::min_element(values, values + count);
  for (int i = 0; i < count; ++i) values[i] -= minimum;
  return minimum;
}

}  // namespace

MatchingSolution trws(const StoredMrf& mrf, const SolverOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Trws solver(mrf);
  MatchingSolution solution;
  solution.energy = std::numeric_limits<double>::infinity();
  solution.lower_bound = -std::numeric_limits<double>::infinity();
  while (solution.stopped == StopReason::not_run) {
    solver.sweep(Sweep::forth);
    const double lower_bound = solver.sweep(Sweep::back);
    Labelling labels = solver.labelling();
    const double energy = mrf.energy(labels);
    solution.passes.push_back({energy, lower_bound});
    solution.lower_bound = std::max(solution.lower_bound, lower_bound);
    if (energy < solution.energy) {
      solution.energy = energy;
      solution.labels = std::move(labels);
    }
    solution.stopped = progress.cancelled() ? StopReason::cancelled : reason_to_stop(solution.passes, options);
    progress.report(static_cast<double>(solution.passes.size()) / options.passes, GLISSON_TEXT("matching"));
  }
  solution.solve_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return solution;
}

namespace {

// Visits every node once and sends messages onward along the direction. Returns the lower bound, which holds for the
// messages as they are when a sweep has ended.
double Trws::sweep(Sweep direction) {
  double lower_bound = 0;
  for (int step = 0; step < nodes_; ++step) {
    const int s = direction == Sweep::forth ? step : nodes_ - 1 - step;
    lower_bound += gather_belief(s);
    const double gamma = 1.0 / std::max(s, nodes_ - 1 - s);  // as many chains of nodes run through s
    if (direction == Sweep::forth) {
      for (int t = s + 1; t < nodes_; ++t) lower_bound += update_message(s, t, gamma);
    } else {
      for (int t = s - 1; t >= 0; --t) lower_bound += update_message(s, t, gamma);
    }
  }
  return lower_bound;
}

double Trws::gather_belief(int s) {
  const double* unary = &mrf_.unary[static_cast<std::size_t>(s) * static_cast<std::size_t>(labels_)];
  std::copy(unary, unary + labels_, belief_.begin());
  for (int u = 0; u < nodes_; ++u) {
    if (u == s) continue;
    const double* incoming = message(u, s);
    for (int k = 0; k < labels_; ++k) belief_[static_cast<std::size_t>(k)] += incoming[k];
  }
  return take_minimum_off(belief_.data(), labels_);
}

// M_st(l) = min over k of gamma belief_s(k) - M_ts(k) + E_st(k, l), less its own minimum, which is returned.
double Trws::update_message(int s, int t, double gamma) {
  const double* backward = message(t, s);
  for (int k = 0; k < labels_; ++k) {
    offset_[static_cast<std::size_t>(k)] = gamma * belief_[static_cast<std::size_t>(k)] - backward[k];
  }
  double* updated = message(s, t);
  std::fill(updated, updated + labels_, std::numeric_limits<double>::infinity());
  if (s < t) {
    const double* cost = mrf_.pair(s, t);
    for (int k = 0; k < labels_; ++k, cost += labels_) {
      const double offset = offset_[static_cast<std::size_t>(k)];
      for (int l = 0; l < labels_; ++l) updated[l] = std::min(updated[l], offset + cost[l]);
    }
  } else {
    const double* cost = mrf_.pair(t, s);
    for (int l = 0; l < labels_; ++l, cost += labels_) {
      for (int k = 0; k < labels_; ++k)
        updated[l] = std::min(updated[l], offset_[static_cast<std::size_t>(k)] + cost[k]);
    }
  }
  return take_minimum_off(updated, labels_);
}

// Fixes the nodes in their order: each takes the label that is cheapest given the labels fixed before it and the
// messages from the nodes after it (section 4.2 of Kolmogorov's paper).
Labelling Trws::labelling() const {
  Labelling labels(static_cast<std::size_t>(nodes_));
  std::vector<double> cost(static_cast<std::size_t>(labels_));
  for (int s = 0; s < nodes_; ++s) {
    for (int k = 0; k < labels_; ++k) {
      double& sum = cost[static_cast<std::size_t>(k)];
      sum = mrf_.unary[static_cast<std::size_t>(s * labels_ + k)];
      for (int t = 0; t < s; ++t) sum += mrf_.pair(t, s)[labels[static_cast<std::size_t>(t)] * labels_ + k];
      for (int u = s + 1; u < nodes_; ++u) sum += message(u, s)[k];
    }
    labels[static_cast<std::size_t>(s)] = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  }
  return labels;
}

}  // namespace
}  // namespace glisson::registration
