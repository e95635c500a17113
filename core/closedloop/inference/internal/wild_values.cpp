#include "closedloop/inference/internal/wild_values.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glisson::closedloop {
namespace {

double scale_of_most(const Eigen::VectorXd& white);
// Of each row, that it is wild, for noise of that size and so many wild ones in all.
Eigen::ArrayXd probabilities(const Eigen::VectorXd& white, double scale, double wild, const PosteriorOptions& options);
double entropy(double probability);

}  // namespace

WildValues wild_values(const Eigen::VectorXd& white, const PosteriorOptions& options) {
  constexpr int rounds = 50;
  constexpr double settled = 1e-4;  // of a row
  const double rows = double(white.size()), narrow = 1 / (options.wild_times * options.wild_times);
  double scale = scale_of_most(white), wild = options.wild_share * rows;
  Eigen::ArrayXd probability;
  WildValues found;
  for (int round = 0; round < rounds; ++round) {
    probability = probabilities(white, scale, wild, options);
    found.worth = 1 - (1 - narrow) * probability;
    scale = std::max(0.01, std::sqrt(found.worth.dot(white.cwiseAbs2()) / rows));
    const double before = wild;
    wild = probability.sum();
    if (std::abs(wild - before) < settled) break;
  }
  // How many are wild is binomial, of a share that has a beta distribution.
  const double others = 1 / options.wild_share - 1;
  found.log_probability = std::lgamma(1 + wild) + std::lgamma(others + rows - wild) - std::lgamma(1 + others + rows) -
                          std::lgamma(others) + std::lgamma(1 + others) - wild * std::log(options.wild_times) +
                          probability.unaryExpr(&entropy).sum();
  return found;
}

namespace {

// By the median, which wild values hardly move.
double scale_of_most(const Eigen::VectorXd& white) {
  constexpr double of_the_median = 1.4826;  // a normal's deviation over the median of its absolute values
  std::vector<double> sizes(white.begin(), white.end());
  for (double& size : sizes) size = std::abs(size);
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(0.01, of_the_median * *middle);
}

Eigen::ArrayXd probabilities(const Eigen::VectorXd& white, double scale, double wild, const PosteriorOptions& options) {
  const double narrow = 1 / (options.wild_times * options.wild_times);
  const double others = 1 / options.wild_share - 1;
  // Expected logarithms of a share of a beta distribution, to a twentieth of a nat.
  const double log_odds = std::log(wild + 0.5) - std::log(others + double(white.size()) - wild - 0.5);
  const Eigen::ArrayXd log_of_row =
      log_odds - std::log(options.wild_times) + 0.5 * (1 - narrow) * white.array().square() / (scale * scale);
  return 1 / (1 + (-log_of_row.cwiseMin(700)).exp());
}

double entropy(double probability) {
  const auto part = [](double share) { return share > 0 ? -share * std::log(share) : 0.0; };
  return part(probability) + part(1 - probability);
}

}  // namespace
}  // namespace glisson::closedloop
