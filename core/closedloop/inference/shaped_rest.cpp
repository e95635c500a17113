#include "closedloop/inference/shaped_rest.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <vector>

#include "closedloop/experiment/residual.h"
#include "closedloop/inference/internal/log_sum.h"
#include "closedloop/inference/laplace.h"

namespace glisson::closedloop {
namespace {

// A residual in two parts: along the shapes, and all the rest. n rows are worth n over `correlation`.
struct Parts {
  double along = 0;  // sums of squares
  double across = 0;
  double directions = 0;
  double rows = 0;
  double correlation = 1;
};

enum class NoiseSize { as_stated, no_smaller };

// ln of the probability of both parts, up to what all have in common, for a combination of one amplitude.
double log_evidence(const Parts& parts, double amplitude, NoiseSize size, const PosteriorOptions& options) {
  const double worth = (parts.rows - parts.directions) / parts.correlation;
  const double width = 1 / std::sqrt(2 * worth), step = std::min(width, options.noise_scale) / 3;
  const double alone = 0.5 * std::log(std::max(parts.across / (parts.rows - parts.directions), 1e-6));
  const double all = 0.5 * std::log(std::max((parts.across + parts.along) / parts.rows, 1e-6));
  const double begin = std::min({0.0, alone, all}) - 10 * width, end = std::max({0.0, alone, all}) + 10 * width;
  const double of_direction = amplitude * amplitude * parts.rows / parts.directions;
  std::vector<double> of_scale;
  for (double log_scale = begin; log_scale <= end; log_scale += step) {
    const double variance = std::exp(2 * log_scale), along = parts.correlation * variance + of_direction;
    const double below = size == NoiseSize::no_smaller ? std::min(0.0, log_scale / options.noise_scale) : 0;
    of_scale.push_back(log_density_of_noise_scale(log_scale, options).value - 0.5 * below * below - worth * log_scale -
                       0.5 * parts.across / parts.correlation / variance - 0.5 * parts.directions * std::log(along) -
                       0.5 * parts.along / along);
  }
  return log_sum(of_scale) + std::log(step);
}

double log_evidence(const Parts& parts, const Amplitude& amplitude, NoiseSize size, const PosteriorOptions& options) {
  constexpr int steps = 12;         // each way
  constexpr double per_spread = 4;  // so that they reach three deviations
  std::vector<double> logs, weights;
  for (int i = -steps; i <= steps; ++i) {
    const double off = i / per_spread;
    weights.push_back(-0.5 * off * off);
    logs.push_back(weights.back() +
                   log_evidence(parts, amplitude.middle * std::exp(off * amplitude.spread), size, options));
  }
  return log_sum(logs) - log_sum(weights);
}

}  // namespace

ShapedRest::ShapedRest(const Observations& observations, const Eigen::MatrixXd& white_shapes,
                       const PosteriorOptions& options)
    : observations_(observations), options_(options) {
  constexpr double independent = 1e-6;  // of the largest eigenvalue
  const Eigen::RowVectorXd sizes = white_shapes.colwise().norm().cwiseMax(1e-12);
  const Eigen::MatrixXd scaled = white_shapes.array().rowwise() / sizes.array();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(scaled.transpose() * scaled);
  const Eigen::VectorXd& squares = gram.eigenvalues();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < squares.size(); ++i)
    if (squares[i] > independent * squares.maxCoeff()) kept.push_back(i);
  directions_ = scaled * gram.eigenvectors()(Eigen::all, kept) * squares(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

double ShapedRest::log_odds(const Eigen::VectorXd& white, const Amplitude& amplitude,
                            const Amplitude& own_error) const {
  if (directions_.cols() == 0 || directions_.cols() >= white.size()) return 0;
  const Eigen::VectorXd along = directions_.transpose() * white;
  const Eigen::VectorXd across = white - directions_ * along;
  const Parts parts{along.squaredNorm(), across.squaredNorm(), double(directions_.cols()), double(white.size()),
                    correlation_length(observations_, across)};
  double noise = log_evidence(parts, 0, NoiseSize::as_stated, options_);
  if (own_error.middle > 0)
    noise = log_sum({noise, log_evidence(parts, own_error, NoiseSize::as_stated, options_)}) - std::log(2.0);
  return log_evidence(parts, amplitude, NoiseSize::no_smaller, options_) - noise;
}

}  // namespace glisson::closedloop
