#include "mechanics/materials/relaxation.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::mechanics {

Result<void> check_relaxation(const Relaxation& relaxation) {
  if (relaxation.size() > most_relaxation_terms) {
    return failure("relaxation-invalid", GLISSON_TEXT("A relaxation has at most {0} terms, and {1} are given."),
                   {fmt::format("{}", most_relaxation_terms), fmt::format("{}", relaxation.size())});
  }
  for (std::size_t k = 0; k < relaxation.size(); ++k) {
    const auto& [weight, time_s] = relaxation[k];
    if (weight > 0 && weight < 1 && time_s > 0 && std::isfinite(time_s)) continue;
    return failure("relaxation-invalid",
                   GLISSON_TEXT("Term {0} of a relaxation needs a weight between 0 and 1 and a time above zero."),
                   {fmt::format("{}", k + 1)});
  }
  constexpr double rounding = 1e-9;
  if (long_term_share(relaxation) > rounding) return {};
  return failure("relaxation-invalid",
                 GLISSON_TEXT("The weights of a relaxation sum to {0}: they must leave something of the stiffness, and "
                              "sum to less than 1."),
                 {fmt::format("{:.6g}", 1 - long_term_share(relaxation))});
}

double long_term_share(const Relaxation& relaxation) {
  double share = 1;
  for (const RelaxationTerm& term : relaxation) share -= term.weight;
  return share;
}

std::vector<RelaxationStep> steps_of(const Relaxation& relaxation, double step_s) {
  std::vector<RelaxationStep> steps;
  for (const RelaxationTerm& term : relaxation) {
    const double x = step_s / term.time_s;
    steps.push_back({std::exp(-x), term.weight * -std::expm1(-x) / x});
  }
  return steps;
}

double share_within(const Relaxation& relaxation, double step_s) {
  double share = long_term_share(relaxation);
  for (const RelaxationStep& step : steps_of(relaxation, step_s)) share += step.share;
  return share;
}

// The transforms of both functions multiply to one: the modulus has its poles where 1 + sum a / (1 - r T) is zero, r
// the rate 1 / tau. That grows from minus to plus infinity between two rates 1 / T, and to 1 beyond the last.
Relaxation relaxation_of(std::vector<CreepTerm> creep) {
  std::erase_if(creep, [](const CreepTerm& term) { return !(term.amplitude > 0); });
  std::sort(creep.begin(), creep.end(), [](const auto& a, const auto& b) { return a.time_s > b.time_s; });
  std::vector<CreepTerm> apart;
  double sum = 0;
  for (const CreepTerm& term : creep) {
    sum += term.amplitude;
    if (!apart.empty() && apart.back().time_s == term.time_s) {
      apart.back().amplitude += term.amplitude;
    } else {
      apart.push_back(term);
    }
  }
  Relaxation relaxation;
  for (std::size_t k = 0; k < apart.size(); ++k) {
    double below = 1 / apart[k].time_s;
    double above = k + 1 < apart.size() ? 1 / apart[k + 1].time_s : (1 + sum) / apart[k].time_s;
    const auto at = [&](double rate) {
      double value = 1;
      for (const CreepTerm& term : apart) value += term.amplitude / (1 - rate * term.time_s);
      return value;
    };
    for (int halving = 0; halving < 200; ++halving) {
      const double middle = below + (above - below) / 2;
      (at(middle) < 0 ? below : above) = middle;
    }
    const double rate = below + (above - below) / 2;
    double slope = 0;
    for (const CreepTerm& term : apart) {
      const double off = 1 - rate * term.time_s;
      slope += term.amplitude * term.time_s / (off * off);
    }
    const double weight = 1 / (rate * slope);
    if (weight > 0) relaxation.push_back({weight, 1 / rate});  // of times as good as equal one term is left
  }
  return relaxation;
}

}  // namespace glisson::mechanics
