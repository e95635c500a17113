#include "closedloop/inference/smooth_rest.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

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
};

// What each row stands for: rows of the experiment that are averaged.
using Grouping = std::vector<std::vector<Eigen::Index>>;
Grouping grouped(const Observations& observations, double correlation, std::size_t maximum);
std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double correlation);

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
    constexpr double step = 1e-3;
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
                               const Eigen::VectorXd& residual, double correlation, const PosteriorOptions& options,
                               const Progress& progress) {
  const Grouping groups = grouped(observations, correlation, options.smooth_rows);
  const std::vector<RestBlock> blocks = blocks_of(observations, systematic, residual, groups, correlation);
  SmoothEvidence evidence;
  double square = 0, count = 0;
  for (const RestBlock& block : blocks) {
    square += block.residual.cwiseAbs2().cwiseQuotient(block.noise.diagonal()).sum();
    count += static_cast<double>(block.residual.size());
  }
  const double too_large = 0.5 * std::log(std::max(1e-3, square / count));
  evidence.noise = std::max(log_evidence_from({0.0}, blocks, false, options, progress),
                            log_evidence_from({too_large}, blocks, false, options, progress));
  // From long lengths, from short ones, and from a noise that is as large as all of the residual: the evidence has
  // several maxima.
  evidence.smooth = -std::numeric_limits<double>::infinity();
  struct Beginning {
    double length, noise, amplitude;  // the last two as shares of the residual
  };
  const double size = std::sqrt(std::max(0.1, square / count));
  for (const Beginning& start :
       {Beginning{2.0, 1 / size, 1.0}, Beginning{0.7, 1 / size, 1.0}, Beginning{2.0, 1.0, 0.3}}) {
    std::vector<double> x{std::log(start.noise * size)};
    for (const RestBlock& block : blocks) {
      const double mean_square = block.residual.squaredNorm() / static_cast<double>(block.residual.size());
      x.push_back(0.5 * std::log(std::max(0.1, mean_square)) + std::log(start.amplitude));
    }
    x.insert(x.end(), blocks.front().square_distance.size(), std::log(start.length));
    const double from_here = log_evidence_from(std::move(x), blocks, true, options, progress);
    evidence.smooth = std::max(evidence.smooth, from_here);
  }
  return evidence;
}

namespace {

// Places are thinned out; without them neighbours in time, of one trial and direction, are averaged.
Grouping grouped(const Observations& observations, double correlation, std::size_t maximum) {
  const auto rows = static_cast<double>(observations.rows());
  const double wanted = std::min(static_cast<double>(maximum), std::max(10.0, rows / correlation));
  Grouping groups;
  if (observations.has_places()) {
    const auto count = std::min(static_cast<Eigen::Index>(wanted), observations.rows());
    for (Eigen::Index i = 0; i < count; ++i) groups.push_back({i * observations.rows() / count});
    return groups;
  }
  std::map<std::pair<int, int>, std::vector<Eigen::Index>> series;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    series[{observations.trial[i], observations.direction[i]}].push_back(row);
  }
  const auto size = static_cast<std::size_t>(std::ceil(rows / wanted));
  for (const auto& [key, own] : series) {
    for (std::size_t first = 0; first < own.size(); first += size)
      groups.emplace_back(own.begin() + static_cast<std::ptrdiff_t>(first),
                          own.begin() + static_cast<std::ptrdiff_t>(std::min(own.size(), first + size)));
  }
  return groups;
}

std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double correlation) {
  const auto averaged = [&](const Eigen::MatrixXd& columns, const std::vector<std::size_t>& which) {
    Eigen::MatrixXd mean(static_cast<Eigen::Index>(which.size()), columns.cols());
    for (std::size_t i = 0; i < which.size(); ++i)
      mean.row(static_cast<Eigen::Index>(i)) = columns(groups[which[i]], Eigen::all).colwise().mean();
    return mean;
  };
  const Eigen::MatrixXd features = varying_features(observations);
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
    block.noise = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      block.noise(i, i) = std::min(1.0, correlation / double(groups[own[static_cast<std::size_t>(i)]].size()));
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
