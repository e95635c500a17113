#include "closedloop/inference/evidence.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <random>

namespace glisson::closedloop {
namespace {

CrossValidationFolds::Fold fold_without(const ForwardModel& model, const SystematicUncertainty& systematic,
                                        const std::vector<bool>& left_out) {
  const Observations& all = model.observations();
  std::vector<bool> kept = left_out;
  kept.flip();
  return {Whitening(all.noise, systematic, rows_of(all, kept)),
          Whitening(all.noise, systematic, rows_of(all, left_out))};
}

Eigen::VectorXd within_bounds(const ParameterRanges& ranges, const Eigen::VectorXd& values) {
  return values.cwiseMax(ranges.lower).cwiseMin(ranges.upper);
}

// The prediction of the rows left out, from a first-order refit to those kept.
Eigen::VectorXd first_order_prediction(const ForwardModel& model, const Fit& fit,
                                       const CrossValidationFolds::Fold& fold) {
  const Eigen::VectorXd values = values_of(fit.settings);
  if (values.size() == 0) return fit.predicted(fold.left_out.rows());
  const Eigen::VectorXd moved = within_bounds(
      ranges_of(model, fit.settings), values + first_order_change(fit, model.observations().measured, fold.kept));
  return fit.predicted(fold.left_out.rows()) + fit.derivatives(fold.left_out.rows(), Eigen::all) * (moved - values);
}

double chi2_of(const ForwardModel& model, const Fit& fit, const CrossValidationFolds::Fold& fold,
               const Eigen::VectorXd& predicted) {
  Eigen::VectorXd all = fit.predicted;
  all(fold.left_out.rows()) = predicted;
  return fold.left_out.whiten(model.observations().measured - all).squaredNorm();
}

template <typename Predict>
Result<LeftOut> over_folds(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds,
                           Predict&& predict) {
  LeftOut result{fit.predicted, 0};
  for (const CrossValidationFolds::Fold& fold : folds.trials()) {
    Result<Eigen::VectorXd> predicted = predict(fold);
    if (!predicted) return failure(std::move(predicted.error()));
    result.predicted(fold.left_out.rows()) = *predicted;
    result.chi2 += chi2_of(model, fit, fold, *predicted);
  }
  return result;
}

}  // namespace

double bic(double chi2, Eigen::Index rows, Eigen::Index parameters, double correlation) {
  const double worth = std::max(10.0, static_cast<double>(rows) / correlation);
  const double mean_square = chi2 / static_cast<double>(rows);
  const double variance = std::max(1.0, mean_square);
  return worth * (std::log(variance) + mean_square / variance) + static_cast<double>(parameters) * std::log(worth);
}

CrossValidationFolds::CrossValidationFolds(const ForwardModel& model, const EvidenceOptions& options) {
  const Observations& all = model.observations();
  const auto count = static_cast<std::size_t>(all.trial_count());
  if (count < 2) return;
  const SystematicUncertainty systematic = model.systematic_uncertainty();
  for (std::size_t trial = 0; trial < count; ++trial) {
    std::vector<bool> left_out(count, false);
    left_out[trial] = true;
    trials_.push_back(fold_without(model, systematic, left_out));
  }
  // Trials whose load goes beyond that of the others; where all go about as far there is none.
  std::vector<double> largest(count, 0.0);
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    double& of_trial = largest[static_cast<std::size_t>(all.trial[static_cast<std::size_t>(row)])];
    of_trial = std::max(of_trial, std::abs(all.load[row]));
  }
  const double top = *std::max_element(largest.begin(), largest.end());
  std::vector<bool> left_out(count, false);
  for (std::size_t trial = 0; trial < count; ++trial) left_out[trial] = largest[trial] > options.top_load * top;
  if (std::count(left_out.begin(), left_out.end(), false) >= 1)
    largest_load_ = fold_without(model, systematic, left_out);
}

namespace {

// To the rows that a fold keeps: a few steps from where the first order leads; where solves are quick, more of them,
// and from the fit to all rows if that is nearer.
Result<Fit> refitted_to(const ForwardModel& model, const Fit& fit, const CrossValidationFolds::Fold& fold,
                        const EvidenceOptions& options, const Progress& progress) {
  if (parameter_count(fit.settings) == 0) return without_fitting(model, fit.settings, fold.kept);
  const Eigen::VectorXd& measured = model.observations().measured;
  Settings start =
      with_values(fit.settings, within_bounds(ranges_of(model, fit.settings),
                                              values_of(fit.settings) + first_order_change(fit, measured, fold.kept)));
  if (!model.predicts_quickly())
    return closedloop::fit(model, start, fold.kept, {.maximum_iterations = options.refit_iterations}, progress);
  const auto ahead = model.predict(start);
  if (!ahead ||
      fold.kept.whiten(measured - *ahead).squaredNorm() > fold.kept.whiten(measured - fit.predicted).squaredNorm())
    start = fit.settings;
  return closedloop::fit(model, start, fold.kept, {.maximum_iterations = options.refit_iterations_where_quick},
                         progress);
}

}  // namespace

LeftOut leave_out(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds) {
  return *over_folds(model, fit, folds, [&](const CrossValidationFolds::Fold& fold) -> Result<Eigen::VectorXd> {
    return first_order_prediction(model, fit, fold);
  });
}

double left_out_by_zeros(const ForwardModel& model, const CrossValidationFolds& folds) {
  double chi2 = 0;
  for (const CrossValidationFolds::Fold& fold : folds.trials())
    chi2 += fold.left_out.whiten(model.observations().measured).squaredNorm();
  return chi2;
}

double share_of(const Eigen::VectorXd& expected, const Eigen::VectorXd& residual, const Eigen::VectorXd& noise,
                const std::vector<Eigen::Index>& rows, const EvidenceOptions& options) {
  double along = 0, square = 0, left = 0;
  for (const Eigen::Index row : rows) {
    if (!std::isfinite(residual[row])) continue;
    const double e = expected[row] / noise[row], r = residual[row] / noise[row];
    along += e * r;
    square += e * e;
    left += r * r;
  }
  if (square == 0) return 0;
  const double share = std::clamp(along / square, 0.0, options.maximum_share_of_expected_error);
  const auto n = static_cast<double>(rows.size());
  const double variance = std::max(1.0, left / n);
  const double gain = 2 * share * along - share * share * square;
  return gain / variance > std::log(n) ? share : 0.0;
}

Result<LeftOut> leave_out_with_refits(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds,
                                      const EvidenceOptions& options, const Progress& progress) {
  if (parameter_count(fit.settings) == 0) return leave_out(model, fit, folds);
  return over_folds(model, fit, folds, [&](const CrossValidationFolds::Fold& fold) -> Result<Eigen::VectorXd> {
    auto refitted = refitted_to(model, fit, fold, options, progress);
    if (!refitted) return failure(std::move(refitted.error()));
    return Eigen::VectorXd(refitted->predicted(fold.left_out.rows()));
  });
}

std::optional<double> largest_load_chi2(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds,
                                        const EvidenceOptions& options, const Progress& progress) {
  const auto& fold = folds.largest_load();
  if (!fold) return std::nullopt;
  const auto refitted = refitted_to(model, fit, *fold, options, progress);
  if (!refitted) return std::nullopt;
  return fold->left_out.whiten(model.observations().measured - refitted->predicted).squaredNorm();
}

HeldOut held_out_error(const Observations& observations, const Eigen::VectorXd& predicted,
                       const EvidenceOptions& options) {
  const auto resamplings = static_cast<std::size_t>(options.resamplings_of_error);
  const ErrorFigures whole = error_figures(observations, predicted);
  HeldOut error{whole.rms, whole.rms, whole.rms, whole.mean, whole.p95};
  const auto trials = static_cast<std::size_t>(observations.trial_count());
  if (trials < 2) return error;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(observations.trial_count());
  Eigen::VectorXd counts = squares;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    double residual = observations.measured[row] - predicted[row];
    if (!std::isfinite(residual)) continue;
    if (observations.unit == "noise") residual /= observations.noise[row];
    squares[observations.trial[static_cast<std::size_t>(row)]] += residual * residual;
    counts[observations.trial[static_cast<std::size_t>(row)]] += 1;
  }
  std::mt19937 random(1);
  std::uniform_int_distribution<Eigen::Index> any_trial(0, static_cast<Eigen::Index>(trials) - 1);
  std::vector<double> rms;
  for (std::size_t i = 0; i < resamplings; ++i) {
    double sum = 0;
    double count = 0;
    for (std::size_t t = 0; t < trials; ++t) {
      const Eigen::Index trial = any_trial(random);
      sum += squares[trial];
      count += counts[trial];
    }
    rms.push_back(std::sqrt(sum / std::max(1.0, count)));
  }
  std::sort(rms.begin(), rms.end());
  error.low = rms[resamplings / 40];
  error.high = rms[resamplings - 1 - resamplings / 40];
  return error;
}

Eigen::MatrixXd bootstrapped_parameters(const ForwardModel& model, const Fit& fit, const Whitening& whitening,
                                        const EvidenceOptions& options) {
  const int resamplings = options.resamplings_of_parameters;
  const Observations& all = model.observations();
  const ParameterRanges ranges = ranges_of(model, fit.settings);
  const Eigen::VectorXd values = values_of(fit.settings);
  const auto trials = static_cast<std::size_t>(all.trial_count());
  const Eigen::MatrixXd jacobian = whitening.whiten(fit.derivatives) * ranges.prior_width.asDiagonal();
  std::vector<Eigen::MatrixXd> information(trials, Eigen::MatrixXd::Zero(values.size(), values.size()));
  std::vector<Eigen::VectorXd> gradient(trials, Eigen::VectorXd::Zero(values.size()));
  for (std::size_t i = 0; i < whitening.rows().size(); ++i) {
    const auto trial = static_cast<std::size_t>(all.trial[static_cast<std::size_t>(whitening.rows()[i])]);
    const auto row = jacobian.row(static_cast<Eigen::Index>(i));
    information[trial] += row.transpose() * row;
    gradient[trial] += row.transpose() * fit.white[static_cast<Eigen::Index>(i)];
  }
  std::mt19937 random(2);
  std::uniform_int_distribution<std::size_t> any_trial(0, trials - 1);
  Eigen::MatrixXd samples(values.size(), resamplings);
  for (int b = 0; b < resamplings; ++b) {
    Eigen::MatrixXd sum = options.resampling_prior * Eigen::MatrixXd::Identity(values.size(), values.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(values.size());
    for (std::size_t t = 0; t < trials; ++t) {
      const std::size_t trial = any_trial(random);
      sum += information[trial];
      right += gradient[trial];
    }
    const Eigen::VectorXd change = ranges.prior_width.asDiagonal() * sum.ldlt().solve(right);
    samples.col(b) = within_bounds(ranges, values + change);
  }
  return samples;
}

}  // namespace glisson::closedloop
