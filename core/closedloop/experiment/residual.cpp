#include "closedloop/experiment/residual.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <Eigen/QR>
#include <map>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/upper_median.h"

namespace glisson::closedloop {
namespace {

// Values of one trial, direction and place, by time: where there are places, each has its own history.
using Histories = std::map<std::array<double, 5>, std::vector<double>>;
Histories histories(const Observations& observations, const Eigen::VectorXd& values) {
  Histories all;
  for (Eigen::Index row = 0; row < values.size(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    std::array<double, 5> key{double(observations.trial[i]), double(observations.direction[i]), 0, 0, 0};
    if (observations.has_places()) Eigen::Vector3d::Map(key.data() + 2) = observations.place_mm.row(row);
    all[key].push_back(values[row]);
  }
  return all;
}

constexpr double minimum_p = 1e-300;  // below, doubles end

double upper_tail_of_chi_squared(double value, double degrees) {
  return std::max(minimum_p, boost::math::cdf(complement(boost::math::chi_squared(degrees), value)));
}

double upper_tail_of_normal(double value) {
  return std::max(minimum_p, boost::math::cdf(complement(boost::math::normal(), value)));
}

NoiseTest size_test(const Eigen::VectorXd& white);
NoiseTest quantity_test(const Observations& observations, const Eigen::VectorXd& white);
std::map<int, Eigen::VectorXd> by_quantity(const Observations& observations, const Eigen::VectorXd& white);
NoiseTest place_neighbours_test(const Observations& observations, const Eigen::VectorXd& white);
NoiseTest time_neighbours_test(const Observations& observations, const Eigen::VectorXd& white);
NoiseTest score_test(std::string name, std::string sentence, const Eigen::MatrixXd& basis,
                     const Observations& observations, const Eigen::VectorXd& white);
Eigen::MatrixXd by_direction(const Observations& observations, const Eigen::MatrixXd& functions);
Eigen::MatrixXd by_trial(const Observations& observations);

}  // namespace

ErrorFigures error_figures(const Observations& observations, const Eigen::VectorXd& predicted) {
  ErrorFigures figures;
  const auto directions = observations.directions.size();
  std::vector<double> squares_of(directions, 0.0);
  std::vector<double> counts_of(directions, 0.0);
  std::map<int, double> squares_of_point;
  double squares = 0;
  double noise_squares = 0;
  double chi2 = 0;
  double count = 0;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const double residual = observations.measured[row] - predicted[row];
    if (!std::isfinite(residual)) continue;
    const auto direction = static_cast<std::size_t>(observations.direction[static_cast<std::size_t>(row)]);
    const double in_unit = observations.unit == "noise" ? residual / observations.noise[row] : residual;
    squares += in_unit * in_unit;
    noise_squares += observations.unit == "noise" ? 1 : observations.noise[row] * observations.noise[row];
    chi2 += residual * residual / (observations.noise[row] * observations.noise[row]);
    squares_of[direction] += residual * residual;
    counts_of[direction] += 1;
    squares_of_point[observations.point[static_cast<std::size_t>(row)]] += in_unit * in_unit;
    count += 1;
  }
  if (count == 0) return figures;
  figures.rms = std::sqrt(squares / count);
  figures.noise = std::sqrt(noise_squares / count);
  figures.reduced_chi2 = chi2 / count;
  std::vector<double> lengths;
  for (const auto& [point, sum] : squares_of_point) lengths.push_back(std::sqrt(sum));
  std::sort(lengths.begin(), lengths.end());
  for (const double length : lengths) figures.mean += length / static_cast<double>(lengths.size());
  figures.p95 = lengths[std::min(lengths.size() - 1, static_cast<std::size_t>(0.95 * double(lengths.size())))];
  figures.max = lengths.back();
  if (observations.unit == "noise") {
    for (std::size_t d = 0; d < directions; ++d)
      figures.rms_of_direction.push_back(counts_of[d] > 0 ? std::optional(std::sqrt(squares_of[d] / counts_of[d]))
                                                          : std::nullopt);
  }
  return figures;
}

ResidualDiagnostics residual_diagnostics(const Observations& observations, const Eigen::VectorXd& white,
                                         const Eigen::VectorXd& predicted) {
  GLISSON_ASSERT(white.size() == observations.rows());
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(white.size());
  const auto about_the_mean = [](const Eigen::VectorXd& values) {
    return Eigen::VectorXd(values.array() - values.mean());
  };
  ResidualDiagnostics diagnostics;
  auto& tests = diagnostics.tests;
  tests.push_back(size_test(white));
  if (!observations.quantities.empty()) tests.push_back(quantity_test(observations, white));
  tests.push_back(observations.has_places() ? place_neighbours_test(observations, white)
                                            : time_neighbours_test(observations, white));
  tests.push_back(
      score_test("scale", GLISSON_TEXT("it is proportional to the prediction"), predicted, observations, white));
  tests.push_back(score_test("load", GLISSON_TEXT("it changes with the load"),
                             by_direction(observations, about_the_mean(observations.load)), observations, white));
  tests.push_back(score_test("time", GLISSON_TEXT("it changes with time"),
                             by_direction(observations, about_the_mean(observations.time_s)), observations, white));
  tests.push_back(score_test("direction", GLISSON_TEXT("it has a mean in some direction"),
                             by_direction(observations, ones), observations, white));
  if (observations.has_places()) {
    const Eigen::RowVectorXd middle = observations.place_mm.colwise().mean();
    const Eigen::MatrixXd places = observations.place_mm.rowwise() - middle;
    tests.push_back(score_test("place", GLISSON_TEXT("it changes across the specimen"),
                               by_direction(observations, observations.load.asDiagonal() * places), observations,
                               white));
  }
  if (observations.trial_count() > 1)
    tests.push_back(score_test("trials", GLISSON_TEXT("it differs from trial to trial"), by_trial(observations),
                               observations, white));
  const auto minimum =
      std::min_element(tests.begin(), tests.end(), [](const auto& a, const auto& b) { return a.p_value < b.p_value; });
  diagnostics.smallest_p = std::min(1.0, minimum->p_value * static_cast<double>(tests.size()));
  diagnostics.is_noise = diagnostics.smallest_p >= improbable_for_noise;
  return diagnostics;
}

std::vector<std::string> ResidualDiagnostics::shape() const {
  std::vector<NoiseTest> significant;
  for (const NoiseTest& test : tests) {
    if (test.p_value * static_cast<double>(tests.size()) < improbable_for_noise) significant.push_back(test);
  }
  std::stable_sort(significant.begin(), significant.end(),
                   [](const auto& a, const auto& b) { return a.p_value < b.p_value; });
  std::vector<std::string> sentences;
  for (const NoiseTest& test : significant) sentences.push_back(test.sentence);
  return sentences;
}

double rms_of_worst_quantity(const Observations& observations, const Eigen::VectorXd& white) {
  double worst = 0;
  for (const auto& [quantity, values] : by_quantity(observations, white)) {
    const auto count = static_cast<double>(values.size());
    worst = std::max(worst, values.norm() / std::sqrt(count) / (1 + 3 / std::sqrt(2 * count)));
  }
  return worst;
}

double correlation_length(const Observations& observations, const Eigen::VectorXd& white) {
  const Histories series = histories(observations, white);
  double length = 1;
  for (std::size_t lag = 1;; ++lag) {
    double products = 0;
    double squares = 0;
    for (const auto& [key, values] : series) {
      if (values.size() < 4 * lag) continue;
      for (std::size_t i = lag; i < values.size(); ++i) {
        products += values[i] * values[i - lag];
        squares += values[i] * values[i];
      }
    }
    if (squares <= 0 || products / squares < 0.05) return length;
    length += 2 * products / squares;
  }
}

std::optional<double> impossible_noise(const Observations& observations, const Eigen::VectorXd& residual) {
  constexpr double too_small = 0.8, too_large = 1.2;  // nobody knows a noise better
  constexpr std::size_t enough = 30;
  std::vector<double> differences;
  for (const auto& [key, values] : histories(observations, residual.cwiseQuotient(observations.noise)))
    for (std::size_t i = 1; values.size() >= enough && i + 1 < values.size(); ++i)
      differences.push_back(std::abs(values[i + 1] - 2 * values[i] + values[i - 1]));
  if (differences.empty()) return std::nullopt;
  const auto count = static_cast<double>(differences.size());
  constexpr double of_the_median = 1.4826;  // a normal's deviation over the median of its absolute values
  const double scale = of_the_median * upper_median(std::move(differences)) / std::sqrt(6.0);
  // Of that estimate, about, since neighbouring differences share their samples: 1.17 for independent ones.
  const double deviation = 1.63 / std::sqrt(count), sure = 4 * deviation;
  if (scale > std::max(too_large, 1 + sure)) return scale;
  const double all = std::sqrt(residual.cwiseQuotient(observations.noise).squaredNorm() / double(residual.size()));
  return std::max(scale, all) < too_small - deviation / 2 ? std::optional(all) : std::nullopt;
}

namespace {

NoiseTest size_test(const Eigen::VectorXd& white) {
  const double reduced = white.squaredNorm() / static_cast<double>(white.size());
  const double allowed = reduced / (noise_is_known_to * noise_is_known_to);
  return {"size", GLISSON_TEXT("it is larger than the noise"), reduced,
          upper_tail_of_chi_squared(allowed * static_cast<double>(white.size()), static_cast<double>(white.size()))};
}

NoiseTest quantity_test(const Observations& observations, const Eigen::VectorXd& white) {
  NoiseTest worst{"quantity", GLISSON_TEXT("one of the quantities that were measured is off by more than its noise"), 0,
                  1};
  const auto all = by_quantity(observations, white);
  for (const auto& [quantity, values] : all) {
    const NoiseTest one = size_test(values);
    if (one.p_value > worst.p_value) continue;
    worst.statistic = one.statistic;
    worst.p_value = one.p_value;
  }
  worst.p_value = std::min(1.0, worst.p_value * static_cast<double>(all.size()));
  return worst;
}

// None where all rows are judged as one.
std::map<int, Eigen::VectorXd> by_quantity(const Observations& observations, const Eigen::VectorXd& white) {
  std::map<int, std::vector<Eigen::Index>> rows;
  for (Eigen::Index row = 0; row < white.size() && !observations.quantities.empty(); ++row) {
    const int direction = observations.direction[static_cast<std::size_t>(row)];
    rows[observations.quantities[static_cast<std::size_t>(direction)]].push_back(row);
  }
  std::map<int, Eigen::VectorXd> values;
  for (const auto& [quantity, of_it] : rows) values[quantity] = white(of_it);
  return values;
}

// z of sum w_ij r_i r_j, a pair counted once: its variance under independence is the number of pairs.
NoiseTest neighbours(const std::vector<std::pair<Eigen::Index, Eigen::Index>>& pairs, const Eigen::VectorXd& white) {
  double sum = 0;
  for (const auto& [a, b] : pairs) sum += white[a] * white[b];
  const double variance = std::max(1.0, white.squaredNorm() / static_cast<double>(white.size()));
  const double z = pairs.empty() ? 0 : sum / variance / std::sqrt(static_cast<double>(pairs.size()));
  return {"neighbours", GLISSON_TEXT("neighbours are off in the same way"), z, upper_tail_of_normal(z)};
}

NoiseTest place_neighbours_test(const Observations& observations, const Eigen::VectorXd& white) {
  constexpr std::size_t nearest = 4;
  constexpr std::size_t maximum_in_a_group = 1500;  // of markers seen at once; more are thinned out
  std::map<std::array<int, 3>, std::vector<Eigen::Index>> groups;
  for (Eigen::Index row = 0; row < white.size(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    groups[{observations.trial[i], observations.sample[i], observations.direction[i]}].push_back(row);
  }
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (auto& [key, rows] : groups) {
    const std::size_t stride = 1 + rows.size() / maximum_in_a_group;
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < rows.size(); i += stride) kept.push_back(rows[i]);
    std::vector<std::pair<double, Eigen::Index>> others;
    for (const Eigen::Index row : kept) {
      others.clear();
      for (const Eigen::Index other : kept) {
        if (other != row)
          others.emplace_back((observations.place_mm.row(row) - observations.place_mm.row(other)).squaredNorm(), other);
      }
      const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(nearest, others.size()));
      std::partial_sort(others.begin(), end, others.end());
      for (auto it = others.begin(); it != end; ++it) pairs.emplace_back(std::minmax(row, it->second));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return neighbours(pairs, white);
}

NoiseTest time_neighbours_test(const Observations& observations, const Eigen::VectorXd& white) {
  std::map<std::pair<int, int>, Eigen::Index> last;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index row = 0; row < white.size(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const auto [before, first] = last.try_emplace({observations.trial[i], observations.direction[i]}, row);
    if (!first) pairs.emplace_back(before->second, row);
    before->second = row;
  }
  return neighbours(pairs, white);
}

NoiseTest score_test(std::string name, std::string sentence, const Eigen::MatrixXd& basis,
                     const Observations& observations, const Eigen::VectorXd& white) {
  const Eigen::MatrixXd scaled = observations.noise.cwiseInverse().asDiagonal() * basis;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::Index rank = qr.rank();
  NoiseTest test{std::move(name), std::move(sentence), 0, 1};
  if (rank == 0) return test;
  const Eigen::MatrixXd orthonormal = qr.householderQ() * Eigen::MatrixXd::Identity(white.size(), rank);
  test.statistic = (orthonormal.transpose() * white).squaredNorm();
  test.degrees = static_cast<double>(rank);
  test.p_value =
      upper_tail_of_chi_squared(test.statistic / (noise_is_known_to * noise_is_known_to), static_cast<double>(rank));
  return test;
}

// Each function for each direction by itself; functions scaled to order 1 so that their rank can be told.
Eigen::MatrixXd by_direction(const Observations& observations, const Eigen::MatrixXd& functions) {
  const auto directions = static_cast<Eigen::Index>(observations.directions.size());
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(functions.rows(), functions.cols() * directions);
  for (Eigen::Index column = 0; column < functions.cols(); ++column) {
    const double size = functions.col(column).cwiseAbs().maxCoeff();
    if (size == 0) continue;
    for (Eigen::Index row = 0; row < functions.rows(); ++row)
      basis(row, column * directions + observations.direction[static_cast<std::size_t>(row)]) =
          functions(row, column) / size;
  }
  return basis;
}

Eigen::MatrixXd by_trial(const Observations& observations) {
  Eigen::MatrixXd indicator = Eigen::MatrixXd::Zero(observations.rows(), observations.trial_count());
  for (Eigen::Index row = 0; row < observations.rows(); ++row)
    indicator(row, observations.trial[static_cast<std::size_t>(row)]) = 1;
  return by_direction(observations, indicator);
}

}  // namespace
}  // namespace glisson::closedloop
