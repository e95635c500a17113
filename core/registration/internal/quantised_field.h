#pragma once
// A matching field in words: distances, weights and seeds in whole steps, and the way back to energies.

#include <cmath>

#include "registration/internal/trwls_slices.h"
#include "registration/mrf.h"

namespace glisson::registration {

inline constexpr int words_in_widest_vector = 64;  // of 8 bits; arrays are padded to it

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

}  // namespace glisson::registration
