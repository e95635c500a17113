#include "closedloop/inference/smooth_rest.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "closedloop/inference/internal/log_sum.h"
#include "closedloop/inference/internal/rest_blocks.h"
#include "closedloop/inference/internal/stop_when_cancelled.h"
#include "closedloop/inference/laplace.h"

namespace glisson::closedloop {
namespace {

// White or repeating itself, as the blocks have it; of any size, or as it is stated.
double evidence_of_noise(const std::vector<RestBlock>& blocks, bool any_size, const PosteriorOptions& options,
                         const Progress& progress);
double evidence_of_smooth(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                          const Progress& progress);

// Of the noise's size: as it is stated (laplace.h), or any.
LogDensity density_of_size(double log_scale, bool any_size, const PosteriorOptions& options) {
  if (!any_size) return log_density_of_noise_scale(log_scale, options);
  const double spread = options.unknown_noise_scale, off = log_scale / spread;
  const double below = std::min(0.0, log_scale / options.noise_scale);
  // Above the stated noise a half of Cauchy's density, below it the little that is left of the other.
  const double mass = 0.5 + options.noise_scale / (spread * std::sqrt(2 * std::numbers::pi));
  return {-std::log(mass * std::numbers::pi * spread * (1 + off * off)) - 0.5 * below * below,
          -2 * off / (1 + off * off) / spread - below / options.noise_scale};
}

LogDensity log_normal(double x, double middle, double spread) {
  const double off = (x - middle) / spread;
  return {-0.5 * off * off - std::log(spread) - 0.5 * std::log(2 * std::numbers::pi), -off / spread};
}

// -ln of a probability that is made of a prior, a number at a time, and of likelihoods.
struct MinusLog {
  double value = 0;
  double* gradient = nullptr;
  void subtract(std::size_t i, const LogDensity& density) {
    value -= density.value;
    if (gradient != nullptr) gradient[i] = -density.slope;
  }
};

// -ln of the probability of the residuals and of x: the logarithms of the noise's scale and, where there is one, of
// that of the prediction's own error. In coordinates in which both are independent, row by row.
class NoiseAlone : public ceres::FirstOrderFunction {
 public:
  NoiseAlone(const std::vector<RestBlock>& blocks, bool any_size, const PosteriorOptions& options)
      : any_size_(any_size), options_(options), has_mesh_error_(has_mesh_error(blocks)) {
    for (const RestBlock& block : blocks) {
      const Eigen::LLT<Eigen::MatrixXd> noise(block.noise);
      Eigen::VectorXd white = noise.matrixL().solve(block.residual);
      half_log_determinant_ += noise.matrixLLT().diagonal().array().log().sum();
      Eigen::VectorXd mesh = Eigen::VectorXd::Zero(white.size());
      if (has_mesh_error_) {
        const Eigen::MatrixXd half = noise.matrixL().solve(block.mesh);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(noise.matrixL().solve(half.transpose()));
        white = (axes.eigenvectors().transpose() * white).eval();
        mesh = axes.eigenvalues().cwiseMax(0);
      }
      for (Eigen::Index i = 0; i < white.size(); ++i) rows_.push_back({white[i] * white[i], mesh[i]});
    }
  }

  [[nodiscard]] int NumParameters() const override { return has_mesh_error_ ? 2 : 1; }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    MinusLog sum{half_log_determinant_, gradient};
    sum.subtract(0, density_of_size(x[0], any_size_, options_));
    if (has_mesh_error_) sum.subtract(1, log_normal(x[1], 0, options_.mesh_error_scale));
    const double noise = std::exp(2 * x[0]), mesh = has_mesh_error_ ? std::exp(2 * x[1]) : 0;
    double of_noise = 0, of_mesh = 0;
    for (const Row& row : rows_) {
      const double variance = noise + mesh * row.mesh;
      sum.value += 0.5 * (row.square / variance + std::log(variance));
      const double slope = (1 - row.square / variance) / variance;
      of_noise += noise * slope;
      of_mesh += mesh * row.mesh * slope;
    }
    *value = sum.value;
    if (gradient != nullptr) {
      gradient[0] += of_noise;
      if (has_mesh_error_) gradient[1] += of_mesh;
    }
    return std::isfinite(*value);
  }

 private:
  struct Row {
    double square = 0;  // of the residual
    double mesh = 0;    // variance of the prediction's own error; the noise's is 1
  };
  std::vector<Row> rows_;
  double half_log_determinant_ = 0;
  bool any_size_;
  const PosteriorOptions& options_;
  bool has_mesh_error_;
};

// The same with a smooth function: x has the logarithms of each block's amplitude and of each feature's length as well.
// The noise is of any size.
class WithSmoothFunction : public ceres::FirstOrderFunction {
 public:
  WithSmoothFunction(const std::vector<RestBlock>& blocks, const PosteriorOptions& options)
      : blocks_(blocks),
        options_(options),
        amplitudes_(has_mesh_error(blocks) ? 2 : 1),
        lengths_(amplitudes_ + blocks.size()),
        parameters_(lengths_ + blocks.front().square_distance.size()) {}

  [[nodiscard]] int NumParameters() const override { return static_cast<int>(parameters_); }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    MinusLog sum{0, gradient};
    sum.subtract(0, density_of_size(x[0], true, options_));
    if (amplitudes_ > 1) sum.subtract(1, log_normal(x[1], 0, options_.mesh_error_scale));
    for (std::size_t i = amplitudes_; i < lengths_; ++i)
      sum.subtract(i, log_normal(x[i], std::log(options_.smooth_amplitude), options_.smooth_amplitude_spread));
    for (std::size_t i = lengths_; i < parameters_; ++i)
      sum.subtract(i, log_normal(x[i], std::log(options_.smooth_length), options_.smooth_length_spread));
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (!add_block(b, x, sum)) return false;
    *value = sum.value;
    return std::isfinite(*value);
  }

 private:
  // False where its covariance has no factor.
  bool add_block(std::size_t b, const double* x, MinusLog& sum) const {
    const RestBlock& block = blocks_[b];
    const Eigen::Index n = block.residual.size();
    Eigen::MatrixXd exponent = Eigen::MatrixXd::Constant(n, n, 2 * x[amplitudes_ + b]);
    for (std::size_t i = lengths_; i < parameters_; ++i)
      exponent -= 0.5 * std::exp(-2 * x[i]) * block.square_distance[i - lengths_];
    const Eigen::MatrixXd smooth = exponent.array().exp();
    Eigen::MatrixXd covariance = smooth + std::exp(2 * x[0]) * block.noise;
    if (amplitudes_ > 1) covariance += std::exp(2 * x[1]) * block.mesh;
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::VectorXd weights = factor.solve(block.residual);
    sum.value += 0.5 * block.residual.dot(weights) + factor.matrixLLT().diagonal().array().log().sum();
    if (sum.gradient == nullptr) return true;
    // d/dx = 1/2 tr((K^-1 - w w^T) dK/dx)
    const Eigen::MatrixXd inner = factor.solve(Eigen::MatrixXd::Identity(n, n)) - weights * weights.transpose();
    sum.gradient[0] += std::exp(2 * x[0]) * inner.cwiseProduct(block.noise).sum();
    if (amplitudes_ > 1) sum.gradient[1] += std::exp(2 * x[1]) * inner.cwiseProduct(block.mesh).sum();
    const Eigen::MatrixXd along = inner.cwiseProduct(smooth);
    sum.gradient[amplitudes_ + b] += along.sum();
    for (std::size_t i = lengths_; i < parameters_; ++i)
      sum.gradient[i] += 0.5 * std::exp(-2 * x[i]) * along.cwiseProduct(block.square_distance[i - lengths_]).sum();
    return true;
  }

  const std::vector<RestBlock>& blocks_;
  const PosteriorOptions& options_;
  std::size_t amplitudes_, lengths_, parameters_;  // where they begin, and how many there are
};

// At the maximum of the posterior from x, by Laplace's method; -infinity where there is none.
double log_evidence_from(std::vector<double> x, const ceres::GradientProblem& problem, const Progress& progress) {
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
  const ceres::GradientProblem problem(new NoiseAlone(blocks, any_size, options));
  std::vector<double> as_stated(static_cast<std::size_t>(problem.NumParameters()), 0.0);
  std::vector<double> too_large = as_stated;
  too_large.front() = std::log(std::max(0.03, size_of(blocks)));
  return std::max(log_evidence_from(std::move(as_stated), problem, progress),
                  log_evidence_from(std::move(too_large), problem, progress));
}

// The evidence has several maxima: the search begins from long lengths, from short ones, from ripples in time, and from
// a noise that is as large as all of the residual.
double evidence_of_smooth(const std::vector<RestBlock>& blocks, const PosteriorOptions& options,
                          const Progress& progress) {
  struct Beginning {
    double length, in_time, noise, amplitude;  // the last two as shares of the residual
  };
  const ceres::GradientProblem problem(new WithSmoothFunction(blocks, options));
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
    best = std::max(best, log_evidence_from(std::move(x), problem, progress));
  }
  return best;
}

}  // namespace
}  // namespace glisson::closedloop
