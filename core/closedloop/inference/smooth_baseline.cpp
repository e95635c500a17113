#include "closedloop/inference/smooth_baseline.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <vector>

#include "closedloop/inference/internal/stop_when_cancelled.h"
#include "closedloop/inference/smooth_correction.h"

namespace glisson::closedloop {
namespace {

constexpr Eigen::Index maximum_baseline_rows = 400;  // a step of the search costs their cube

// Rows of one direction, which has a process of its own; lengths are shared.
struct BaselineBlock {
  Eigen::VectorXd residual;                      // of the declared model, in units of the noise
  std::vector<Eigen::MatrixXd> square_distance;  // a feature: between any two rows, the feature scaled to unit spread
};

Eigen::MatrixXd features_with_history(const Observations& observations);
std::vector<BaselineBlock> blocks_of(const Observations& observations, const Eigen::VectorXd& residual,
                                     const std::vector<Eigen::Index>& rows);

// -2 ln of the evidence, over the logarithms of each block's amplitude and each feature's length.
class Evidence : public ceres::FirstOrderFunction {
 public:
  Evidence(const std::vector<BaselineBlock>& blocks, double variance)
      : blocks_(blocks), variance_(variance), lengths_(blocks.front().square_distance.size()) {}

  [[nodiscard]] int NumParameters() const override { return static_cast<int>(blocks_.size() + lengths_); }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    if (gradient != nullptr) std::fill(gradient, gradient + NumParameters(), 0.0);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const BaselineBlock& block = blocks_[b];
      const Eigen::Index n = block.residual.size();
      Eigen::MatrixXd exponent = Eigen::MatrixXd::Constant(n, n, 2 * x[b]);
      for (std::size_t f = 0; f < lengths_; ++f)
        exponent -= 0.5 * std::exp(-2 * x[blocks_.size() + f]) * block.square_distance[f];
      const Eigen::MatrixXd smooth = exponent.array().exp();
      const Eigen::LLT<Eigen::MatrixXd> factor(smooth + variance_ * Eigen::MatrixXd::Identity(n, n));
      if (factor.info() != Eigen::Success) return false;
      const Eigen::VectorXd weights = factor.solve(block.residual);
      *value += block.residual.dot(weights) + 2 * factor.matrixLLT().diagonal().array().log().sum();
      if (gradient == nullptr) continue;
      // d/dx = tr((K^-1 - w w^T) dK/dx)
      const Eigen::MatrixXd along =
          (factor.solve(Eigen::MatrixXd::Identity(n, n)) - weights * weights.transpose()).cwiseProduct(smooth);
      gradient[b] += 2 * along.sum();
      for (std::size_t f = 0; f < lengths_; ++f)
        gradient[blocks_.size() + f] +=
            std::exp(-2 * x[blocks_.size() + f]) * along.cwiseProduct(block.square_distance[f]).sum();
    }
    return std::isfinite(*value);
  }

 private:
  const std::vector<BaselineBlock>& blocks_;
  double variance_;
  std::size_t lengths_;
};

// From lengths of two spreads for all features, and from short ones: the evidence has several maxima.
double minimum_bic(const std::vector<BaselineBlock>& blocks, double variance, double rows, const Progress& progress) {
  double minimum = std::numeric_limits<double>::infinity();
  const std::size_t lengths = blocks.front().square_distance.size();
  for (const double length : {2.0, 0.7}) {
    std::vector<double> x;
    for (const BaselineBlock& block : blocks) {
      const double mean_square = block.residual.squaredNorm() / static_cast<double>(block.residual.size());
      x.push_back(0.5 * std::log(std::max(0.1, mean_square)));
    }
    x.insert(x.end(), lengths, std::log(length));
    const ceres::GradientProblem problem(new Evidence(blocks, variance));
    StopWhenCancelled stop(progress);
    ceres::GradientProblemSolver::Options options;
    options.max_num_iterations = 40;
    options.function_tolerance = 1e-3;  // of some hundreds: below what a difference of evidence means
    options.logging_type = ceres::SILENT;
    options.callbacks.push_back(&stop);
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, x.data(), &summary);
    if (std::isfinite(summary.final_cost))
      minimum = std::min(minimum, summary.final_cost + static_cast<double>(x.size()) * std::log(rows));
  }
  return minimum;
}

}  // namespace

double evidence_over_smooth(const Observations& observations, const Eigen::VectorXd& declared,
                            const Eigen::VectorXd& explained, Eigen::Index parameters, double correlation,
                            const Progress& progress) {
  const auto independent = static_cast<Eigen::Index>(static_cast<double>(observations.rows()) / correlation);
  const Eigen::Index wanted = std::clamp<Eigen::Index>(independent, std::min<Eigen::Index>(10, observations.rows()),
                                                       std::min(maximum_baseline_rows, observations.rows()));
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < wanted; ++i) rows.push_back(i * observations.rows() / wanted);
  const auto n = static_cast<double>(wanted);
  const Eigen::VectorXd noise = observations.noise(rows);
  const double mean_square = explained(rows).cwiseQuotient(noise).squaredNorm() / n;
  const double variance = std::max(1.0, mean_square);
  const double named =
      n * (std::log(variance) + mean_square / variance) + static_cast<double>(parameters) * std::log(n);
  const std::vector<BaselineBlock> blocks = blocks_of(observations, declared, rows);
  return minimum_bic(blocks, variance, n, progress) - named;
}

Eigen::MatrixXd varying_features(const Observations& observations) {
  Eigen::MatrixXd features = features_with_history(observations);
  std::vector<Eigen::Index> varying;
  for (Eigen::Index f = 0; f < features.cols(); ++f) {
    features.col(f).array() -= features.col(f).mean();
    const double spread = std::sqrt(features.col(f).squaredNorm() / static_cast<double>(features.rows()));
    if (spread < 1e-12) continue;
    features.col(f) /= spread;
    varying.push_back(f);
  }
  return features(Eigen::all, varying);
}

namespace {

Eigen::MatrixXd features_with_history(const Observations& observations) {
  const Eigen::MatrixXd present = features_of(observations);
  Eigen::MatrixXd features(observations.rows(), present.cols() + 3);
  features.leftCols(present.cols()) = present;
  auto way = features.col(present.cols());
  auto time = features.col(present.cols() + 1);
  auto largest = features.col(present.cols() + 2);
  time = observations.time_s;
  // Rows are grouped by trial and, within it, by time; those of one moment share what was done.
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const double size = std::abs(observations.load[row]);
    if (row == 0 || observations.trial[i] != observations.trial[i - 1]) {
      way[row] = 0;
      largest[row] = size;
    } else if (observations.sample[i] == observations.sample[i - 1]) {
      way[row] = way[row - 1];
      largest[row] = largest[row - 1];
    } else {
      const double change = observations.load[row] - observations.load[row - 1];
      way[row] = change > 0 ? 1 : change < 0 ? -1 : way[row - 1];
      largest[row] = std::max(largest[row - 1], size);
    }
  }
  return features;
}

std::vector<BaselineBlock> blocks_of(const Observations& observations, const Eigen::VectorXd& residual,
                                     const std::vector<Eigen::Index>& rows) {
  const Eigen::MatrixXd features = varying_features(observations);
  std::vector<BaselineBlock> blocks;
  for (int direction = 0; direction < static_cast<int>(observations.directions.size()); ++direction) {
    std::vector<Eigen::Index> own;
    for (const Eigen::Index row : rows) {
      if (observations.direction[static_cast<std::size_t>(row)] == direction) own.push_back(row);
    }
    if (own.empty()) continue;
    BaselineBlock block{residual(own).cwiseQuotient(observations.noise(own)), {}};
    for (Eigen::Index f = 0; f < features.cols(); ++f) {
      const Eigen::VectorXd x = features(own, f);
      block.square_distance.emplace_back((x.replicate(1, x.size()) - x.transpose().replicate(x.size(), 1)).cwiseAbs2());
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace
}  // namespace glisson::closedloop
