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
#include "closedloop/inference/smooth_features.h"

namespace glisson::closedloop {
namespace {

// Rows of one direction, which has a process of its own; lengths are shared. In units of the noise as stated.
struct RestBlock {
  Eigen::VectorXd residual;
  Eigen::MatrixXd noise;                         // covariance
  Eigen::MatrixXd mesh;                          // ... of what the prediction itself may be off by; 0 x 0 for nothing
  std::vector<Eigen::MatrixXd> square_distance;  // a feature: between any two rows, the feature scaled to unit spread
  std::size_t time = 0;                          // which feature is time; as many as there are where none is
};

// What each row stands for: rows of the experiment that are averaged.
using Grouping = std::vector<std::vector<Eigen::Index>>;
Grouping grouped(const Observations& observations, std::size_t maximum);
// `kept`: the share of each error that the next sample of its series repeats.
std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double kept);
// White or repeating itself, as the blocks have it; of any size, or as it is stated.
double evidence_of_noise(const std::vector<RestBlock>& blocks, bool any_size, const PosteriorOptions& options,
                         const Progress& progress);
double evidence_of_smooth(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                          const Progress& progress);
// Root mean square of what is left, in units of what is to be expected of its rows.
double size_of(const std::vector<RestBlock>& blocks);
bool has_mesh_error(const std::vector<RestBlock>& blocks) { return blocks.front().mesh.size() > 0; }

// -ln of the probability of the residuals and of x, which are logarithms: the noise's scale, that of the prediction's
// own error where there is one, and with a smooth function each block's amplitude and each feature's length.
class MinusLogPosterior : public ceres::FirstOrderFunction {
 public:
  MinusLogPosterior(const std::vector<RestBlock>& blocks, bool smooth, bool any_size, const PosteriorOptions& options)
      : blocks_(blocks),
        smooth_(smooth),
        any_size_(any_size),
        options_(options),
        amplitudes_(1 + (has_mesh_error(blocks) ? 1 : 0)),
        lengths_(amplitudes_ + blocks.size()),
        parameters_(smooth ? lengths_ + blocks.front().square_distance.size() : amplitudes_) {}

  [[nodiscard]] int NumParameters() const override { return static_cast<int>(parameters_); }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    if (gradient != nullptr) std::fill(gradient, gradient + NumParameters(), 0.0);
    *value = 0;
    add_priors(x, *value, gradient);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (!add_block(b, x, *value, gradient)) return false;
    return std::isfinite(*value);
  }

 private:
  void add_priors(const double* x, double& value, double* gradient) const {
    if (any_size_) {
      const double spread = options_.unknown_noise_scale, off = x[0] / spread;
      const double below = std::min(0.0, x[0] / options_.noise_scale);
      // Above the stated noise a half of Cauchy's density, below it the little that is left of the other.
      const double mass = 0.5 + options_.noise_scale / (spread * std::sqrt(2 * std::numbers::pi));
      value += std::log(mass * std::numbers::pi * spread * (1 + off * off)) + 0.5 * below * below;
      if (gradient != nullptr) gradient[0] = 2 * off / (1 + off * off) / spread + below / options_.noise_scale;
    } else {
      const LogDensity density = log_density_of_noise_scale(x[0], options_);
      value -= density.value;
      if (gradient != nullptr) gradient[0] = -density.slope;
    }
    const auto normal = [&](std::size_t i, double middle, double spread) {
      const double off = (x[i] - std::log(middle)) / spread;
      value += 0.5 * off * off + std::log(spread) + 0.5 * std::log(2 * std::numbers::pi);
      if (gradient != nullptr) gradient[i] = off / spread;
    };
    if (amplitudes_ > 1) normal(1, 1, options_.mesh_error_scale);
    if (!smooth_) return;
    for (std::size_t i = amplitudes_; i < lengths_; ++i)
      normal(i, options_.smooth_amplitude, options_.smooth_amplitude_spread);
    for (std::size_t i = lengths_; i < parameters_; ++i)
      normal(i, options_.smooth_length, options_.smooth_length_spread);
  }

  // False where its covariance has no factor.
  bool add_block(std::size_t b, const double* x, double& value, double* gradient) const {
    const RestBlock& block = blocks_[b];
    const Eigen::Index n = block.residual.size();
    Eigen::MatrixXd covariance = std::exp(2 * x[0]) * block.noise;
    if (amplitudes_ > 1) covariance += std::exp(2 * x[1]) * block.mesh;
    Eigen::MatrixXd smooth;
    if (smooth_) {
      Eigen::MatrixXd exponent = Eigen::MatrixXd::Constant(n, n, 2 * x[amplitudes_ + b]);
      for (std::size_t i = lengths_; i < parameters_; ++i)
        exponent -= 0.5 * std::exp(-2 * x[i]) * block.square_distance[i - lengths_];
      smooth = exponent.array().exp();
      covariance += smooth;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::VectorXd weights = factor.solve(block.residual);
    value += 0.5 * block.residual.dot(weights) + factor.matrixLLT().diagonal().array().log().sum();
    if (gradient == nullptr) return true;
    // d/dx = 1/2 tr((K^-1 - w w^T) dK/dx)
    const Eigen::MatrixXd inner = factor.solve(Eigen::MatrixXd::Identity(n, n)) - weights * weights.transpose();
    gradient[0] += std::exp(2 * x[0]) * inner.cwiseProduct(block.noise).sum();
    if (amplitudes_ > 1) gradient[1] += std::exp(2 * x[1]) * inner.cwiseProduct(block.mesh).sum();
    if (!smooth_) return true;
    const Eigen::MatrixXd along = inner.cwiseProduct(smooth);
    gradient[amplitudes_ + b] += along.sum();
    for (std::size_t i = lengths_; i < parameters_; ++i)
      gradient[i] += 0.5 * std::exp(-2 * x[i]) * along.cwiseProduct(block.square_distance[i - lengths_]).sum();
    return true;
  }

  const std::vector<RestBlock>& blocks_;
  bool smooth_, any_size_;
  const PosteriorOptions& options_;
  std::size_t amplitudes_, lengths_, parameters_;  // where they begin, and how many there are
};

// At the maximum of the posterior from x, by Laplace's method; -infinity where there is none.
double log_evidence_from(std::vector<double> x, const std::vector<RestBlock>& blocks, bool smooth, bool any_size,
                         const PosteriorOptions& options, const Progress& progress) {
  const ceres::GradientProblem problem(new MinusLogPosterior(blocks, smooth, any_size, options));
  StopWhenCancelled stop(progress);
  ceres::GradientProblemSolver::Options solver;
  solver.max_num_iterations = 40;
  solver.function_tolerance = 1e-5;  // of some hundreds of nats
  solver.logging_type = ceres::SILENT;
  solver.callbacks.push_back(&stop);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(solver, problem, x.data(), &summary);
  if (!summary.IsSolutionUsable() || !std::isfinite(summary.final_cost))
    return -std::numeric_limits<double>::infinity();  // already its beginning has no factor
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
  std::vector<double> as_stated{evidence_of_noise(white, false, options, progress)};
  std::vector<double> of_any_size{evidence_of_noise(white, true, options, progress)};
  if (observations.has_places()) {
    std::size_t taken = 0;
    for (const auto& group : groups) taken += group.size();
    evidence.share_of_rows = double(taken) / double(observations.rows());
  } else {
    // Or noise that repeats itself, as instruments' may.
    as_stated.front() += std::log(1 - options.noise_repeats);
    of_any_size.front() += std::log(1 - options.noise_repeats);
    const double log_share = std::log(options.noise_repeats / double(options.noise_kept.size()));
    for (const double kept : options.noise_kept) {
      const std::vector<RestBlock> blocks = blocks_of(observations, systematic, residual, groups, kept);
      as_stated.push_back(log_share + evidence_of_noise(blocks, false, options, progress));
      of_any_size.push_back(log_share + evidence_of_noise(blocks, true, options, progress));
    }
  }
  evidence.noise = log_sum(as_stated);
  evidence.smooth = log_sum({std::log(1 - options.noise_alone) + evidence_of_smooth(white, options, progress),
                             std::log(options.noise_alone) + log_sum(of_any_size)});
  return evidence;
}

namespace {

double evidence_of_noise(const std::vector<RestBlock>& blocks, bool any_size, const PosteriorOptions& options,
                         const Progress& progress) {
  std::vector<double> as_stated(has_mesh_error(blocks) ? 2 : 1, 0.0);
  std::vector<double> too_large = as_stated;
  too_large.front() = std::log(std::max(0.03, size_of(blocks)));
  return std::max(log_evidence_from(std::move(as_stated), blocks, false, any_size, options, progress),
                  log_evidence_from(std::move(too_large), blocks, false, any_size, options, progress));
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
    if (has_mesh_error(blocks)) x.push_back(0);
    for (const RestBlock& block : blocks) {
      const double mean_square = block.residual.squaredNorm() / static_cast<double>(block.residual.size());
      x.push_back(0.5 * std::log(std::max(0.1, mean_square)) + std::log(start.amplitude));
    }
    for (std::size_t f = 0; f < blocks.front().square_distance.size(); ++f)
      x.push_back(std::log(f == blocks.front().time ? start.in_time : start.length));
    best = std::max(best, log_evidence_from(std::move(x), blocks, true, true, options, progress));
  }
  return best;
}

double size_of(const std::vector<RestBlock>& blocks) {
  double square = 0, count = 0;
  for (const RestBlock& block : blocks) {
    Eigen::VectorXd expected = block.noise.diagonal();
    if (block.mesh.size() > 0) expected += block.mesh.diagonal();
    square += block.residual.cwiseAbs2().cwiseQuotient(expected).sum();
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
    if (systematic.directions.cols() > 0 || systematic.shared.size() > 0) block.mesh = Eigen::MatrixXd::Zero(n, n);
    if (systematic.directions.cols() > 0) {
      const Eigen::MatrixXd off = averaged(inverse_noise.asDiagonal() * systematic.directions, own);
      block.mesh += off * off.transpose();
    }
    if (systematic.shared.size() > 0) {
      const Eigen::VectorXd shared = averaged(inverse_noise.cwiseProduct(systematic.shared), own);
      const auto group_of = [&](Eigen::Index i) {
        return systematic.group[static_cast<std::size_t>(groups[own[static_cast<std::size_t>(i)]].front())];
      };
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          if (group_of(i) == group_of(j)) block.mesh(i, j) += shared[i] * shared[j];
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
