#include "studies/gate/paired_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace glisson::studies {
namespace {

constexpr std::size_t exact_up_to = 200;

// Twice the mid-rank of each |difference|, zeros ranked too; whole numbers.
std::vector<int> doubled_ranks(const std::vector<double>& differences) {
  const std::size_t n = differences.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t k) { return std::abs(differences[k]); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<int> ranks(n);
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    while (end < n && size(order[end]) == size(order[begin])) ++end;
    for (std::size_t k = begin; k < end; ++k) ranks[order[k]] = static_cast<int>(begin + 1 + end);
  }
  return ranks;
}

// The share of all choices of signs whose positive ranks sum to `sum` or more.
double exact_tail(const std::vector<int>& ranks, int sum) {
  const int total = std::accumulate(ranks.begin(), ranks.end(), 0);
  std::vector<double> share(static_cast<std::size_t>(total) + 1, 0);
  share[0] = 1;
  int reached = 0;
  for (const int rank : ranks) {
    reached += rank;
    for (int s = reached; s >= 0; --s) share[s] = 0.5 * (share[s] + (s >= rank ? share[s - rank] : 0));
  }
  double tail = 0;
  for (int s = std::max(sum, 0); s <= total; ++s) tail += share[s];
  return std::min(1.0, tail);
}

double normal_tail(const std::vector<int>& ranks, int sum) {
  double mean = 0, variance = 0;
  for (const double rank : ranks) {
    mean += rank / 2;
    variance += rank * rank / 4;
  }
  return 0.5 * std::erfc((sum - 1 - mean) / std::sqrt(2 * variance));  // doubled ranks: half a step is 1
}

// The means of any two differences, a difference with itself too, in order.
std::vector<double> walsh_averages(std::vector<double> differences) {
  std::sort(differences.begin(), differences.end());
  if (differences.size() > exact_up_to) {
    std::vector<double> some(exact_up_to);
    for (std::size_t k = 0; k < exact_up_to; ++k)
      some[k] = differences[k * (differences.size() - 1) / (exact_up_to - 1)];
    differences = std::move(some);
  }
  std::vector<double> means;
  means.reserve(differences.size() * (differences.size() + 1) / 2);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) means.push_back((differences[i] + differences[j]) / 2);
  }
  std::sort(means.begin(), means.end());
  return means;
}

// How many Walsh averages lie outside at each end of the 95 % interval, by the statistic's normal approximation.
std::size_t outside(std::size_t n, std::size_t averages) {
  const double size = static_cast<double>(n);
  const double sd = std::sqrt(size * (size + 1) * (2 * size + 1) / 24);
  const double count = std::floor(size * (size + 1) / 4 - 1.96 * sd);
  return count < 0 ? 0 : std::min(static_cast<std::size_t>(count), (averages - 1) / 2);
}

}  // namespace

PairedChange paired_change(std::vector<double> differences) {
  PairedChange outcome;
  outcome.pairs = static_cast<int>(differences.size());
  if (differences.empty()) return outcome;
  const std::vector<int> all = doubled_ranks(differences);
  std::vector<int> ranks;
  int positive = 0, negative = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (differences[k] == 0) continue;
    ranks.push_back(all[k]);
    (differences[k] > 0 ? positive : negative) += all[k];
  }
  if (!ranks.empty()) {
    const auto tail = ranks.size() <= exact_up_to ? exact_tail : normal_tail;
    outcome.p_greater = tail(ranks, positive);
    outcome.p_less = tail(ranks, negative);
  }
  const std::vector<double> means = walsh_averages(differences);
  const std::size_t beyond = outside(std::min(differences.size(), exact_up_to), means.size());
  outcome.change = median(means);
  outcome.interval = {means[beyond], means[means.size() - 1 - beyond]};
  return outcome;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

double smallest_p(int pairs) { return std::pow(0.5, pairs); }

std::vector<double> holm_corrected(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> corrected(p.size());
  double so_far = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    so_far = std::max(so_far, std::min(1.0, static_cast<double>(order.size() - k) * p[order[k]]));
    corrected[order[k]] = so_far;
  }
  return corrected;
}

}  // namespace glisson::studies
