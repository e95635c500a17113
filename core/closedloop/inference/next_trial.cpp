#include "closedloop/inference/next_trial.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <random>

#include "closedloop/inference/internal/log_sum.h"

namespace glisson::closedloop {
namespace {

// What is weighed against each other: an explanation and what it expects of each further trial.
struct Standing {
  const WeighedExplanation* explanation = nullptr;
  double probability = 0;                      // among those that stand
  std::vector<ExpectedMeasurement> of_trials;  // no rows where the trial cannot be solved
};
// The declared model's, of the rows of all trials: in noises, and what one deviation is there, noise and own error.
struct Declared {
  Eigen::VectorXd predicted, deviation;
};
Declared declared_further(const Weighing& weighing, const std::vector<FurtherTrial>& trials);
Standing something_else(const WeighedExplanation& explanation, const Standing& likeliest, const Declared& declared,
                        const std::vector<FurtherTrial>& trials);

std::vector<Standing> standing(const Weighing& weighing, const Posterior& posterior,
                               const std::vector<FurtherTrial>& trials, const DiagnosisOptions& options,
                               const Progress& progress);
std::vector<PossibleTrial> possible(const std::vector<Standing>& all, const std::vector<FurtherTrial>& trials);
double separation(const Standing& one, const Standing& other, std::size_t trial);
double entropy(const std::vector<double>& probability);
ExpectedMeasurement together(const Standing& standing, const ExpectedMeasurement& first,
                             const ExpectedMeasurement& second);
std::vector<std::string> told_apart(const std::vector<Standing>& all, std::size_t trial, double clear_separation);

}  // namespace

Result<NextTrials> next_trials(const Weighing& weighing, const Posterior& posterior, const DiagnosisOptions& options,
                               const Progress& progress) {
  const NextTrialOptions& asked = options.next_trial;
  const std::vector<FurtherTrial> trials = weighing.model.further_trials();
  const std::vector<Standing> all = standing(weighing, posterior, trials, options, progress);
  if (progress.cancelled()) return cancelled();
  if (all.size() < 2) return NextTrials{};
  std::vector<double> probability;
  for (const Standing& one : all) probability.push_back(one.probability);
  const double doubt = entropy(probability);
  if (doubt < asked.minimum_doubt) return NextTrials{};

  NextTrials next{{}, possible(all, trials)};
  std::vector<ExpectedMeasurement> so_far(all.size());
  std::vector<bool> is_chosen(trials.size(), false);
  double known = 0;  // information of the trials chosen so far
  while (next.to_make.size() < asked.trials) {
    std::vector<double> information(trials.size(), 0);
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (is_chosen[t]) continue;
      std::vector<ExpectedMeasurement> with;
      for (std::size_t k = 0; k < all.size() && all[k].of_trials[t].mean.size() > 0; ++k)
        with.push_back(together(all[k], so_far[k], all[k].of_trials[t]));
      if (with.size() == all.size()) information[t] = expected_information(probability, with, asked.draws);
      if (progress.cancelled()) return cancelled();
    }
    if (next.to_make.empty())
      for (std::size_t t = 0; t < trials.size(); ++t)
        next.possible[t].doubt_removed = std::min(1.0, information[t] / doubt);
    const double most = information.empty() ? 0 : *std::max_element(information.begin(), information.end());
    if (most - known < asked.worth_a_trial * doubt) break;
    const auto best = std::find_if(information.begin(), information.end(),
                                   [&](double one) { return one >= most - asked.about_as_good * doubt; });
    const auto t = static_cast<std::size_t>(best - information.begin());
    next.to_make.push_back({trials[t].sentence, trials[t].conditions, told_apart(all, t, options.clear_separation),
                            std::min(1.0, *best / doubt)});
    is_chosen[t] = true;
    known = *best;
    for (std::size_t k = 0; k < all.size(); ++k) so_far[k] = together(all[k], so_far[k], all[k].of_trials[t]);
  }
  return next;
}

double expected_information(const std::vector<double>& probability, const std::vector<ExpectedMeasurement>& expected,
                            int draws) {
  struct Density {
    Eigen::LLT<Eigen::MatrixXd> inner;  // 1 + S^T S
    double half_log_determinant = 0;
  };
  std::vector<Density> densities;
  for (const ExpectedMeasurement& one : expected) {
    const auto count = one.spread.cols();
    Density density;
    density.inner.compute(Eigen::MatrixXd::Identity(count, count) + one.spread.transpose() * one.spread);
    density.half_log_determinant = density.inner.matrixLLT().diagonal().array().log().sum();
    densities.push_back(std::move(density));
  }
  const auto log_density = [&](std::size_t k, const Eigen::VectorXd& y) {
    const Eigen::VectorXd off = y - expected[k].mean;
    const Eigen::VectorXd along = expected[k].spread.transpose() * off;
    return -0.5 * (off.squaredNorm() - along.dot(densities[k].inner.solve(along))) - densities[k].half_log_determinant;
  };
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto drawn = [&](Eigen::Index count) {
    return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index) { return normal(random); }));
  };
  double information = 0;
  std::vector<double> logs(expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    double sum = 0;
    for (int i = 0; i < draws; ++i) {
      const Eigen::VectorXd open = drawn(expected[k].spread.cols());
      const Eigen::VectorXd y = expected[k].mean + expected[k].spread * open + drawn(expected[k].mean.size());
      for (std::size_t j = 0; j < expected.size(); ++j) logs[j] = std::log(probability[j]) + log_density(j, y);
      sum += logs[k] - log_sum(logs) - std::log(probability[k]);
    }
    information += probability[k] * sum / draws;
  }
  return std::max(0.0, information);
}

namespace {

// The parameters' covariance in deviations of the prior is (A + 1)^-1, A what the measurements say of them.
Eigen::MatrixXd spread_of(const Weighing& weighing, const LocalFit& fit, const Eigen::MatrixXd& derivatives,
                          const PosteriorOptions& options) {
  if (derivatives.cols() == 0) return derivatives;
  const ParameterPrior prior = prior_of(weighing.model, fit.settings, options);
  const Eigen::VectorXd slope = prior.slope(values_of(fit.settings));
  const double variance = weighing.correlation * std::max(1.0, fit.chi2 / static_cast<double>(fit.rows));
  const Eigen::MatrixXd precision =
      Eigen::MatrixXd(slope.asDiagonal() * fit.information * slope.asDiagonal() / variance) +
      Eigen::MatrixXd::Identity(slope.size(), slope.size());
  const Eigen::LLT<Eigen::MatrixXd> factor(precision);
  const Eigen::MatrixXd in_deviations = derivatives * slope.asDiagonal();
  return factor.matrixL().solve(in_deviations.transpose()).transpose();
}

std::vector<Standing> standing(const Weighing& weighing, const Posterior& posterior,
                               const std::vector<FurtherTrial>& trials, const DiagnosisOptions& options,
                               const Progress& progress) {
  std::vector<Standing> all;
  const Declared declared = declared_further(weighing, trials);
  double sum = 0;
  for (const WeighedExplanation& one : posterior) {
    if (one.something_else || one.probability < options.next_trial.stands || all.size() == options.next_trial.compared)
      continue;
    const auto linear = weighing.model.linearise_further(one.fit.settings);
    if (progress.cancelled()) return {};
    if (!linear) continue;
    Standing standing{&one, one.probability, {}};
    Eigen::Index row = 0;
    for (const FurtherTrial& trial : trials) {
      const auto deviation = declared.deviation.segment(row, trial.rows);
      ExpectedMeasurement expected{
          linear->predicted.segment(row, trial.rows).cwiseQuotient(deviation),
          deviation.cwiseInverse().asDiagonal() * linear->derivatives.middleRows(row, trial.rows)};
      row += trial.rows;
      if (expected.mean.allFinite() && expected.spread.allFinite())
        expected.spread = spread_of(weighing, one.fit, expected.spread, options.posterior);
      else
        expected = {};
      standing.of_trials.push_back(std::move(expected));
    }
    sum += one.probability;
    all.push_back(std::move(standing));
  }
  const auto unknown =
      std::find_if(posterior.begin(), posterior.end(), [](const auto& one) { return one.something_else; });
  if (!all.empty() && unknown != posterior.end() && unknown->probability >= options.next_trial.unknown_stands) {
    sum += unknown->probability;
    all.push_back(something_else(*unknown, all.front(), declared, trials));
  }
  for (Standing& one : all) one.probability /= sum;
  return all;
}

// The prediction is off in a further trial by as large a share of the response as in those that were made.
Declared declared_further(const Weighing& weighing, const std::vector<FurtherTrial>& trials) {
  Eigen::Index rows = 0;
  for (const FurtherTrial& trial : trials) rows += trial.rows;
  const auto further = weighing.model.predict_further({});
  Declared declared{further && further->allFinite() ? *further : Eigen::VectorXd::Zero(rows),
                    Eigen::VectorXd::Ones(rows)};
  const auto made = weighing.model.predict({});
  if (weighing.systematic.expected.size() == 0 || !made || made->norm() == 0) return declared;
  const double share = weighing.systematic.expected.norm() / made->norm();
  declared.deviation = (1 + (share * declared.predicted.array()).square()).sqrt();
  return declared;
}

// What is unknown says nothing of a trial. That the likeliest cause acts in each as it should would be chance: what it
// changes there is off by as much again, in each trial anew.
Standing something_else(const WeighedExplanation& explanation, const Standing& likeliest, const Declared& declared,
                        const std::vector<FurtherTrial>& trials) {
  Standing standing{&explanation, explanation.probability, likeliest.of_trials};
  Eigen::Index row = 0;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    ExpectedMeasurement& expected = standing.of_trials[t];
    const Eigen::Index rows = trials[t].rows;
    if (expected.mean.size() > 0)
      expected.spread =
          expected.mean - declared.predicted.segment(row, rows).cwiseQuotient(declared.deviation.segment(row, rows));
    row += rows;
  }
  return standing;
}

std::vector<PossibleTrial> possible(const std::vector<Standing>& all, const std::vector<FurtherTrial>& trials) {
  std::vector<PossibleTrial> one_by_one;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    PossibleTrial trial{trials[t].sentence, trials[t].conditions, 0, {}};
    for (std::size_t k = 1; k < all.size() && !all[k].explanation->something_else; ++k)
      trial.separations.push_back({all[k].explanation->kinds, separation(all[k], all.front(), t)});
    one_by_one.push_back(std::move(trial));
  }
  return one_by_one;
}

// In noises, all rows together; not a number where either cannot be solved.
double separation(const Standing& one, const Standing& other, std::size_t trial) {
  const Eigen::VectorXd &here = one.of_trials[trial].mean, &there = other.of_trials[trial].mean;
  if (here.size() == 0 || there.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  return (here - there).norm();
}

double entropy(const std::vector<double>& probability) {
  double sum = 0;
  for (const double p : probability)
    if (p > 0) sum -= p * std::log(p);
  return sum;
}

// Of two trials: an explanation's parameters are the same in both, what is unknown has its own in each.
ExpectedMeasurement together(const Standing& standing, const ExpectedMeasurement& first,
                             const ExpectedMeasurement& second) {
  if (first.mean.size() == 0) return second;
  const Eigen::Index rows = first.mean.size(), columns = first.spread.cols();
  const Eigen::Index at = standing.explanation->something_else ? columns : 0;
  ExpectedMeasurement both;
  both.mean.resize(rows + second.mean.size());
  both.mean << first.mean, second.mean;
  both.spread = Eigen::MatrixXd::Zero(both.mean.size(), at + second.spread.cols());
  both.spread.topLeftCorner(rows, columns) = first.spread;
  both.spread.bottomRightCorner(second.mean.size(), second.spread.cols()) = second.spread;
  return both;
}

// The kinds of the explanations that this trial parts from the likeliest.
std::vector<std::string> told_apart(const std::vector<Standing>& all, std::size_t trial, double clear_separation) {
  std::vector<std::string> kinds;
  for (std::size_t k = 1; k < all.size() && !all[k].explanation->something_else; ++k) {
    if (!(separation(all[k], all.front(), trial) >= clear_separation)) continue;
    for (const std::string& kind : all[k].explanation->kinds) {
      const auto& leading = all.front().explanation->kinds;
      if (std::count(leading.begin(), leading.end(), kind) == 0 && std::count(kinds.begin(), kinds.end(), kind) == 0)
        kinds.push_back(kind);
    }
  }
  return kinds;
}

}  // namespace
}  // namespace glisson::closedloop
