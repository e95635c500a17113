#include "closedloop/inference/smooth_rest.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "closedloop/inference/internal/log_sum.h"
#include "closedloop/inference/internal/stop_when_cancelled.h"
#include "closedloop/inference/laplace.h"
#include "closedloop/inference/smooth_baseline.h"

namespace glisson::closedloop {
namespace {

// Rows of one direction, which has a process of its own; lengths are shared. In units of the noise as stated.
struct RestBlock {
  Eigen::VectorXd residual;
  Eigen::MatrixXd noise;                         // covariance, with what the prediction itself may be off by
  std::vector<Eigen::MatrixXd> square_distance;  // a feature: between any two rows, the feature scaled to unit spread
  std::size_t time = 0;                          // which feature is time; as many as there are where none is
};

// What each row stands for: rows of the experiment that are averaged.
using Grouping = std::vector<std::vector<Eigen::Index>>;
Grouping grouped(const Observations& observations, std::size_t maximum);
// `kept`: the share of each error that the next sample of its series repeats.
std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double kept);
double evidence_of_noise(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                         const Progress& progress);
double evidence_of_smooth(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                          const Progress& progress);
// Root mean square of what is left, in units of the noise of its rows.
double size_of(const std::vector<RestBlock>& blocks);

// -ln of the probability of the residuals and of x: the noise's logarithm, and with a smooth function each block's
// amplitude's and each feature's length's.
class MinusLogPosterior : public ceres::FirstOrderFunction {
 public:
  MinusLogPosterior(const std::vector<RestBlock>& blocks, bool smooth, const PosteriorOptions& options)
      : blocks_(blocks),
        smooth_(smooth),
        options_(options),
        lengths_(smooth ? blocks.front().square_distance.size() : 0) {}

  [[nodiscard]] int NumParameters() const override {
    return 1 + (smooth_ ? static_cast<int>(blocks_.size() + lengths_) : 0);
  }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    const double scale = std::exp(2 * x[0]);
    if (gradient != nullptr) std::fill(gradient, gradient + NumParameters(), 0.0);
    // With something else the noise may be of any size.
    if (smooth_) {
      const double off = x[0] / options_.unknown_noise_scale;
      *value = std::log(std::numbers::pi * options_.unknown_noise_scale * (1 + off * off));
      if (gradient != nullptr) gradient[0] = 2 * off / (1 + off * off) / options_.unknown_noise_scale;
    } else {
      *value = -log_density_of_noise_scale(x[0], options_);
      if (gradient != nullptr) gradient[0] = x[0] / (options_.noise_scale * options_.noise_scale);
    }
    const auto normal = [&](std::size_t i, double middle, double spread) {
      const double off = (x[i] - std::log(middle)) / spread;
      *value += 0.5 * off * off + std::log(spread) + 0.5 * std::log(2 * std::numbers::pi);
      if (gradient != nullptr) gradient[i] = off / spread;
    };
    if (smooth_) {
      for (std::size_t b = 0; b < blocks_.size(); ++b)
        normal(1 + b, options_.smooth_amplitude, options_.smooth_amplitude_spread);
      for (std::size_t f = 0; f < lengths_; ++f)
        normal(first_length() + f, options_.smooth_length, options_.smooth_length_spread);
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const RestBlock& block = blocks_[b];
      const Eigen::Index n = block.residual.size();
      const Eigen::MatrixXd noise = scale * block.noise;
      Eigen::MatrixXd smooth;
      if (smooth_) {
        Eigen::MatrixXd exponent = Eigen::MatrixXd::Constant(n, n, 2 * x[1 + b]);
        for (std::size_t f = 0; f < lengths_; ++f)
          exponent -= 0.5 * std::exp(-2 * x[first_length() + f]) * block.square_distance[f];
        smooth = exponent.array().exp();
      }
      const Eigen::LLT<Eigen::MatrixXd> factor(smooth_ ? Eigen::MatrixXd(noise + smooth) : noise);
      if (factor.info() != Eigen::Success) return false;
      const Eigen::VectorXd weights = factor.solve(block.residual);
      *value += 0.5 * block.residual.dot(weights) + factor.matrixLLT().diagonal().array().log().sum();
      if (gradient == nullptr) continue;
      // d/dx = 1/2 tr((K^-1 - w w^T) dK/dx)
      const Eigen::MatrixXd inner = factor.solve(Eigen::MatrixXd::Identity(n, n)) - weights * weights.transpose();
      gradient[0] += inner.cwiseProduct(noise).sum();
      if (!smooth_) continue;
      const Eigen::MatrixXd along = inner.cwiseProduct(smooth);
      gradient[1 + b] += along.sum();
      for (std::size_t f = 0; f < lengths_; ++f)
        gradient[first_length() + f] +=
            0.5 * std::exp(-2 * x[first_length() + f]) * along.cwiseProduct(block.square_distance[f]).sum();
    }
    return std::isfinite(*value);
  }

 private:
  [[nodiscard]] std::size_t first_length() const { return 1 + blocks_.size(); }

  const std::vector<RestBlock>& blocks_;
  bool smooth_;
  const PosteriorOptions& options_;
  std::size_t lengths_;
};

// At the maximum of the posterior from x, by Laplace's method; -infinity where there is none.
double log_evidence_from(std::vector<double> x, const std::vector<RestBlock>& blocks, bool smooth,
                         const PosteriorOptions& options, const Progress& progress) {
  const ceres::GradientProblem problem(new MinusLogPosterior(blocks, smooth, options));
  StopWhenCancelled stop(progress);
  ceres::GradientProblemSolver::Options solver;
  solver.max_num_iterations = 40;
  solver.function_tolerance = 1e-5;  // of some hundreds of nats
  solver.logging_type = ceres::SILENT;
  solver.callbacks.push_back(&stop);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(solver, problem, x.data(), &summary);
  if (!std::isfinite(summary.final_cost)) return -std::numeric_limits<double>::infinity();
  const auto count = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd curvature(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    constexpr double step = 1e-3;  // of a logarithm; the difference errs by its square
    Eigen::VectorXd ahead(count), behind(count);
    double value = 0;
    std::vector<double> moved = x;
    moved[static_cast<std::size_t>(i)] += step;
    bool valid = problem.Evaluate(moved.data(), &value, ahead.data());
    moved[static_cast<std::size_t>(i)] -= 2 * step;
    valid = problem.Evaluate(moved.data(), &value, behind.data()) && valid;
    curvature.col(i) = valid ? Eigen::VectorXd((ahead - behind) / (2 * step)) : Eigen::VectorXd::Unit(count, i);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen((curvature + curvature.transpose()) / 2,
                                                             Eigen::EigenvaluesOnly);
  // A maximum is seldom flatter than the priors; where the search ended short of it this bounds what is left out.
  constexpr double flattest = 0.1;
  return -summary.final_cost + 0.5 * static_cast<double>(count) * std::log(2 * std::numbers::pi) -
         0.5 * eigen.eigenvalues().cwiseMax(flattest).array().log().sum();
}

}  // namespace

SmoothEvidence smooth_evidence(const Observations& observations, const SystematicUncertainty& systematic,
                               const Eigen::VectorXd& residual, const PosteriorOptions& options,
                               const Progress& progress) {
  const Grouping groups = grouped(observations, options.smooth_rows);
  const std::vector<RestBlock> white = blocks_of(observations, systematic, residual, groups, 0);
  SmoothEvidence evidence;
  evidence.smooth = evidence_of_smooth(white, options, progress);
  evidence.noise = evidence_of_noise(white, options, progress);
  if (observations.has_places()) {
    std::size_t taken = 0;
    for (const auto& group : groups) taken += group.size();
    evidence.share_of_rows = double(taken) / double(observations.rows());
    return evidence;
  }
  // Or noise that repeats itself, as instruments' may.
  std::vector<double> logs{std::log(1 - options.noise_repeats) + evidence.noise};
  for (const double kept : options.noise_kept) {
    const double log_share = std::log(options.noise_repeats / double(options.noise_kept.size()));
    logs.push_back(log_share +
                   evidence_of_noise(blocks_of(observations, systematic, residual, groups, kept), options, progress));
  }
  evidence.noise = log_sum(logs);
  return evidence;
}

namespace {

double evidence_of_noise(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                         const Progress& progress) {
  const double too_large = std::log(std::max(0.03, size_of(blocks)));
  return std::max(log_evidence_from({0.0}, blocks, false, options, progress),
                  log_evidence_from({too_large}, blocks, false, options, progress));
}

// The evidence has several maxima: the search begins from long lengths, from short ones, from ripples in time, and from
// a noise that is as large as all of the residual.
double evidence_of_smooth(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                          const Progress& progress) {
  struct Beginning {
    double length, in_time, noise, amplitude;  // the last two as shares of the residual
  };
  const double size = std::max(0.3, size_of(blocks));
  double best = -std::numeric_limits<double>::infinity();
  for (const Beginning& start : {Beginning{2.0, 2.0, 1 / size, 1.0}, Beginning{0.7, 0.7, 1 / size, 1.0},
                                 Beginning{3.0, 0.1, 1 / size, 0.7}, Beginning{2.0, 2.0, 1.0, 0.3}}) {
    std::vector<double> x{std::log(start.noise * size)};
    for (const RestBlock& block : blocks) {
      const double mean_square = block.residual.squaredNorm() / static_cast<double>(block.residual.size());
      x.push_back(0.5 * std::log(std::max(0.1, mean_square)) + std::log(start.amplitude));
    }
    for (std::size_t f = 0; f < blocks.front().square_distance.size(); ++f)
      x.push_back(std::log(f == blocks.front().time ? start.in_time : start.length));
    best = std::max(best, log_evidence_from(std::move(x), blocks, true, options, progress));
  }
  return best;
}

double size_of(const std::vector<RestBlock>& blocks) {
  double square = 0, count = 0;
  for (const RestBlock& block : blocks) {
    square += block.residual.cwiseAbs2().cwiseQuotient(block.noise.diagonal()).sum();
    count += static_cast<double>(block.residual.size());
  }
  return std::sqrt(square / count);
}

// Neighbours in time, of one trial, direction and place, are averaged: enough of them to leave so many groups. Where
// places are many, some are passed over, and each of the others is left a few means.
Grouping grouped(const Observations& observations, std::size_t maximum) {
  constexpr std::size_t means_of_a_place = 3;  // the fewest that show a bend
  const bool places = observations.has_places();
  using Place = std::array<double, 3>;
  std::map<std::tuple<int, int, Place>, std::size_t> known;
  std::vector<std::vector<Eigen::Index>> series;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const Place place =
        places ? Place{observations.place_mm(row, 0), observations.place_mm(row, 1), observations.place_mm(row, 2)}
               : Place{};
    const auto [at, is_new] =
        known.try_emplace({observations.trial[i], observations.direction[i], place}, series.size());
    if (is_new) series.emplace_back();
    series[at->second].push_back(row);
  }
  std::size_t size = (static_cast<std::size_t>(observations.rows()) + maximum - 1) / maximum, every = 1;
  if (places) {
    std::size_t groups = 0, longest = 0;
    for (const auto& own : series) {
      groups += std::min(means_of_a_place, own.size());
      longest = std::max(longest, own.size());
    }
    every = (groups + maximum - 1) / maximum;
    if (every > 1) size = (longest + means_of_a_place - 1) / means_of_a_place;
  }
  Grouping groups;
  for (std::size_t s = 0; s < series.size(); s += every) {
    const auto& own = series[s];
    for (std::size_t first = 0; first < own.size(); first += size)
      groups.emplace_back(own.begin() + static_cast<std::ptrdiff_t>(first),
                          own.begin() + static_cast<std::ptrdiff_t>(std::min(own.size(), first + size)));
  }
  return groups;
}

// Features have lost what they were called: time is the one that goes with it.
std::size_t feature_of_time(const Observations& observations, const Eigen::MatrixXd& features) {
  constexpr double the_same = 1 - 1e-9;
  const Eigen::VectorXd since = observations.time_s.array() - observations.time_s.mean();
  Eigen::Index f = 0;
  while (f < features.cols() && std::abs(features.col(f).dot(since)) < the_same * features.col(f).norm() * since.norm())
    ++f;
  return static_cast<std::size_t>(f);
}

// Of means over groups of samples, each of which has a variance of 1 and keeps a share of the error before it.
Eigen::MatrixXd covariance_of_means(const Observations& observations, const Grouping& groups,
                                    const std::vector<std::size_t>& own, double kept) {
  const auto n = static_cast<Eigen::Index>(own.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& first = groups[own[static_cast<std::size_t>(i)]];
    if (kept <= 0) {
      covariance(i, i) = 1 / double(first.size());
      continue;
    }
    for (Eigen::Index j = 0; j <= i; ++j) {
      const auto& second = groups[own[static_cast<std::size_t>(j)]];
      const auto a = static_cast<std::size_t>(first.front()), b = static_cast<std::size_t>(second.front());
      if (observations.trial[a] != observations.trial[b]) continue;
      double sum = 0;
      for (const Eigen::Index row : first)
        for (const Eigen::Index other : second)
          sum += std::pow(kept, std::abs(observations.sample[static_cast<std::size_t>(row)] -
                                         observations.sample[static_cast<std::size_t>(other)]));
      covariance(i, j) = covariance(j, i) = sum / double(first.size() * second.size());
    }
  }
  return covariance;
}

std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double kept) {
  const auto averaged = [&](const Eigen::MatrixXd& columns, const std::vector<std::size_t>& which) {
    Eigen::MatrixXd mean(static_cast<Eigen::Index>(which.size()), columns.cols());
    for (std::size_t i = 0; i < which.size(); ++i)
      mean.row(static_cast<Eigen::Index>(i)) = columns(groups[which[i]], Eigen::all).colwise().mean();
    return mean;
  };
  const Eigen::MatrixXd features = varying_features(observations);
  const std::size_t time = feature_of_time(observations, features);
  const Eigen::VectorXd inverse_noise = observations.noise.cwiseInverse();
  std::vector<RestBlock> blocks;
  for (int direction = 0; direction < static_cast<int>(observations.directions.size()); ++direction) {
    std::vector<std::size_t> own;
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (observations.direction[static_cast<std::size_t>(groups[g].front())] == direction) own.push_back(g);
    if (own.empty()) continue;
    RestBlock block;
    block.residual = averaged(inverse_noise.cwiseProduct(residual), own);
    const auto n = static_cast<Eigen::Index>(own.size());
    block.noise = covariance_of_means(observations, groups, own, kept);
    block.time = time;
    if (systematic.directions.cols() > 0) {
      const Eigen::MatrixXd off = averaged(inverse_noise.asDiagonal() * systematic.directions, own);
      block.noise += off * off.transpose();
    }
    if (systematic.shared.size() > 0) {
      const Eigen::VectorXd shared = averaged(inverse_noise.cwiseProduct(systematic.shared), own);
      const auto group_of = [&](Eigen::Index i) {
        return systematic.group[static_cast<std::size_t>(groups[own[static_cast<std::size_t>(i)]].front())];
      };
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          if (group_of(i) == group_of(j)) block.noise(i, j) += shared[i] * shared[j];
    }
    const Eigen::MatrixXd at = averaged(features, own);
    for (Eigen::Index f = 0; f < at.cols(); ++f) {
      const Eigen::VectorXd x = at.col(f);
      block.square_distance.emplace_back((x.replicate(1, n) - x.transpose().replicate(n, 1)).cwiseAbs2());
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace
}  // namespace glisson::closedloop
