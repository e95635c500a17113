#include "closedloop/inference/laplace.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <numbers>
#include <utility>

#include "closedloop/inference/internal/log_sum.h"

namespace glisson::closedloop {
namespace {

// The likelihood about a fit over deviations u of the prior, for noise of one size: -1/2 d^T A d + g^T d.
struct Quadratic {
  Eigen::VectorXd at;     // u of the fit
  Eigen::VectorXd g;      // downhill
  Eigen::MatrixXd a;      // information
  std::vector<int> free;  // the parameters that are not held at a bound by what was measured
  std::vector<int> held;
};
Quadratic quadratic(const LocalFit& fit, const ParameterPrior& prior, double variance);
double log_integral(const Quadratic& likelihood, const ParameterPrior& prior);
double log_normal_mass(double low, double high);

}  // namespace

LocalFit local_fit(const Fit& fit, const Whitening& whitening) {
  const Eigen::MatrixXd jacobian = whitening.whiten(fit.derivatives);
  LocalFit local{fit.settings, fit.chi2, fit.white.size(), jacobian.transpose() * fit.white,
                 jacobian.transpose() * jacobian};
  if (!fit.converged) local.downhill.setZero();
  return local;
}

Eigen::VectorXd ParameterPrior::inward(const Eigen::VectorXd& values) const {
  Eigen::VectorXd u(values.size());
  for (Eigen::Index p = 0; p < u.size(); ++p) {
    const double x = scales[static_cast<std::size_t>(p)] == Scale::logarithmic ? std::log(values[p]) : values[p];
    u[p] = std::clamp((x - center[p]) / spread[p], lower[p], upper[p]);
  }
  return u;
}

Eigen::VectorXd ParameterPrior::outward(const Eigen::VectorXd& deviations) const {
  Eigen::VectorXd values = center + spread.cwiseProduct(deviations);
  for (Eigen::Index p = 0; p < values.size(); ++p)
    if (scales[static_cast<std::size_t>(p)] == Scale::logarithmic) values[p] = std::exp(values[p]);
  return values;
}

Eigen::VectorXd ParameterPrior::slope(const Eigen::VectorXd& values) const {
  Eigen::VectorXd slope = spread;
  for (Eigen::Index p = 0; p < values.size(); ++p)
    if (scales[static_cast<std::size_t>(p)] == Scale::logarithmic) slope[p] *= values[p];
  return slope;
}

ParameterPrior prior_of(const ForwardModel& model, const Settings& settings, const PosteriorOptions& options) {
  const Eigen::Index count = parameter_count(settings);
  ParameterPrior prior{
      Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count), {}};
  Eigen::Index at = 0;
  for (const Setting& setting : settings) {
    for (const Parameter& parameter : effect_of(model, setting)->parameters) {
      const auto scaled = [&](double value) {
        if (parameter.scale == Scale::linear) return value;
        return std::log(std::max(value, std::numeric_limits<double>::min()));
      };
      const double low = scaled(parameter.prior_low), high = scaled(parameter.prior_high);
      prior.center[at] = (low + high) / 2;
      prior.spread[at] = (high - low) / 2 / options.deviations_to_prior_end;
      prior.lower[at] = (scaled(parameter.lower) - prior.center[at]) / prior.spread[at];
      prior.upper[at] = (scaled(parameter.upper) - prior.center[at]) / prior.spread[at];
      prior.scales.push_back(parameter.scale);
      ++at;
    }
  }
  return prior;
}

LogDensity log_density_of_noise_scale(double log_scale, const PosteriorOptions& options) {
  const auto part = [&](double probability, double spread) {
    const double x = log_scale / spread;
    return std::log(probability) - 0.5 * x * x - std::log(spread) - 0.5 * std::log(2 * std::numbers::pi);
  };
  const auto precision = [](double spread) { return 1 / (spread * spread); };
  const double well = part(1 - options.roughly_stated, options.noise_scale);
  const double roughly = part(options.roughly_stated, options.rough_noise_scale);
  const double both = log_sum({well, roughly});
  return {both, -log_scale * (std::exp(well - both) * precision(options.noise_scale) +
                              std::exp(roughly - both) * precision(options.rough_noise_scale))};
}

LogEvidence log_evidence(const ForwardModel& model, const LocalFit& fit, double correlation,
                         const PosteriorOptions& options) {
  const ParameterPrior prior = prior_of(model, fit.settings, options);
  const double worth = static_cast<double>(fit.rows) / correlation;
  const double chi2 = fit.chi2 / correlation;
  // As narrow as the noise's prior, or as the likelihood, whichever is narrower; from one to the other.
  const double middle = 0.5 * std::log(std::max(chi2 / worth, 1e-6));
  const double width = 1 / std::sqrt(2 * worth);
  const double step = std::min(width, options.noise_scale) / 3;
  const double begin = std::min(0.0, middle) - 10 * width;
  const auto count = static_cast<std::size_t>((std::max(0.0, middle) + 10 * width - begin) / step) + 1;
  std::vector<double> of_scale(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double log_scale = begin + static_cast<double>(i) * step;
    of_scale[i] = log_density_of_noise_scale(log_scale, options).value - worth * log_scale -
                  chi2 / 2 * std::exp(-2 * log_scale) + std::log(step);
  }
  const double highest = *std::max_element(of_scale.begin(), of_scale.end());
  std::vector<double> with_parameters, alone;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr double negligible = 40;  // nats: below what a sum of doubles keeps
    if (of_scale[i] < highest - negligible) continue;
    const double log_scale = begin + static_cast<double>(i) * step;
    alone.push_back(of_scale[i]);
    with_parameters.push_back(of_scale[i] +
                              log_integral(quadratic(fit, prior, correlation * std::exp(2 * log_scale)), prior));
  }
  return {log_sum(with_parameters), log_sum(alone)};
}

LocalFit at_maximum(const ForwardModel& model, const Whitening& whitening, LocalFit fit, double correlation,
                    const PosteriorOptions& options, const Progress& progress) {
  if (parameter_count(fit.settings) == 0) return fit;
  const ParameterPrior prior = prior_of(model, fit.settings, options);
  const Eigen::VectorXd& measured = model.observations().measured;
  for (int i = 0; i < options.refinements && !progress.cancelled(); ++i) {
    const double variance = correlation * std::max(1.0, fit.chi2 / static_cast<double>(fit.rows));
    const Quadratic likelihood = quadratic(fit, prior, variance);
    if (likelihood.free.empty()) return fit;
    const Eigen::MatrixXd precision =
        likelihood.a(likelihood.free, likelihood.free) +
        Eigen::MatrixXd::Identity(Eigen::Index(likelihood.free.size()), Eigen::Index(likelihood.free.size()));
    const Eigen::VectorXd slope = likelihood.g(likelihood.free) - likelihood.at(likelihood.free);
    const Eigen::VectorXd of_free = precision.llt().solve(slope);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(likelihood.at.size());
    step(likelihood.free) = of_free;
    if (slope.dot(of_free) < options.refined_enough * options.refined_enough) return fit;
    const auto cost = [&](double chi2, const Eigen::VectorXd& u) { return chi2 / variance + u.squaredNorm(); };
    const double before = cost(fit.chi2, likelihood.at);
    bool better = false;
    for (double share = 1; share > 0.1 && !better; share /= 2) {
      const Eigen::VectorXd u = (likelihood.at + share * step).cwiseMax(prior.lower).cwiseMin(prior.upper);
      const Settings moved = with_values(fit.settings, prior.outward(u));
      const auto predicted = model.predict(moved);
      if (!predicted || !(cost(whitening.whiten(measured - *predicted).squaredNorm(), u) < before)) continue;
      auto there = without_fitting(model, moved, whitening);
      if (!there || !there->derivatives.allFinite()) return fit;
      fit = local_fit(*there, whitening);
      better = true;
    }
    if (!better) return fit;
  }
  return fit;
}

namespace {

Quadratic quadratic(const LocalFit& fit, const ParameterPrior& prior, double variance) {
  const Eigen::VectorXd values = values_of(fit.settings);
  const Eigen::VectorXd slope = prior.slope(values);
  Quadratic q{prior.inward(values),
              slope.cwiseProduct(fit.downhill) / variance,
              slope.asDiagonal() * fit.information * slope.asDiagonal() / variance,
              {},
              {}};
  constexpr double close = 1e-6;  // what a fit that ran into a bound is off by
  for (int p = 0; p < static_cast<int>(values.size()); ++p) {
    const bool low = q.at[p] <= prior.lower[p] + close && q.g[p] < 0;
    const bool high = q.at[p] >= prior.upper[p] - close && q.g[p] > 0;
    (low || high ? q.held : q.free).push_back(p);
  }
  return q;
}

// Of the prior times the likelihood over its value at the fit. Bounds cut both off, parameter by parameter: exact for
// one, and near it where they are hardly correlated.
double log_integral(const Quadratic& likelihood, const ParameterPrior& prior) {
  double sum = 0;
  for (Eigen::Index p = 0; p < likelihood.at.size(); ++p) sum -= log_normal_mass(prior.lower[p], prior.upper[p]);
  const auto cut_off = [&](int p, double mean, double deviation) {
    return log_normal_mass((prior.lower[p] - mean) / deviation, (prior.upper[p] - mean) / deviation);
  };
  // Held at a bound: by itself, the others staying where they are.
  for (const int p : likelihood.held) {
    const double precision = likelihood.a(p, p) + 1;
    const double slope = likelihood.g[p] - likelihood.at[p];
    sum += -0.5 * likelihood.at[p] * likelihood.at[p] + 0.5 * slope * slope / precision - 0.5 * std::log(precision) +
           cut_off(p, likelihood.at[p] + slope / precision, 1 / std::sqrt(precision));
  }
  if (likelihood.free.empty()) return sum;
  const auto count = static_cast<Eigen::Index>(likelihood.free.size());
  const Eigen::LLT<Eigen::MatrixXd> precision(likelihood.a(likelihood.free, likelihood.free) +
                                              Eigen::MatrixXd::Identity(count, count));
  if (precision.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  const Eigen::VectorXd at = likelihood.at(likelihood.free);
  const Eigen::VectorXd slope = likelihood.g(likelihood.free) - at;
  const Eigen::VectorXd step = precision.solve(slope);
  const Eigen::VectorXd variance = precision.solve(Eigen::MatrixXd::Identity(count, count)).diagonal();
  sum += -0.5 * at.squaredNorm() + 0.5 * slope.dot(step) - precision.matrixLLT().diagonal().array().log().sum();
  for (Eigen::Index i = 0; i < count; ++i)
    sum += cut_off(likelihood.free[static_cast<std::size_t>(i)], at[i] + step[i], std::sqrt(variance[i]));
  return sum;
}

// ln (Phi(high) - Phi(low)), also far out, where the difference itself is 0 in doubles.
double log_normal_mass(double low, double high) {
  if (!(low < high)) return -std::numeric_limits<double>::infinity();
  if (low > 0) return log_normal_mass(-high, -low);
  const auto log_below = [](double x) {
    if (x > -30) return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
    return -0.5 * x * x - std::log(-x) - 0.5 * std::log(2 * std::numbers::pi);
  };
  const double upper = log_below(high);
  return upper + std::log(-std::expm1(std::min(-1e-12, log_below(low) - upper)));
}

}  // namespace
}  // namespace glisson::closedloop
