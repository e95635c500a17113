#include "closedloop/inference/smooth_correction.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>

namespace glisson::closedloop {
namespace {

constexpr Eigen::Index maximum_correction_rows =
    600;                              // the process rests on so many rows, taken evenly from all trials
constexpr double worth_having = 0.9;  // of the sum of squares without it

Eigen::MatrixXd scaled(const SmoothCorrection& smooth, const Eigen::MatrixXd& features) {
  return (features.rowwise() - smooth.center).array().rowwise() / (smooth.spread.array() * smooth.length_scale);
}

Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, const std::vector<int>& directions_a, const Eigen::MatrixXd& b,
                       const std::vector<int>& directions_b) {
  Eigen::MatrixXd value(a.rows(), b.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < b.rows(); ++j) {
      value(i, j) = directions_a[static_cast<std::size_t>(i)] == directions_b[static_cast<std::size_t>(j)]
                        ? std::exp(-(a.row(i) - b.row(j)).squaredNorm() / 2)
                        : 0;
    }
  }
  return value;
}

struct Rows {
  Eigen::MatrixXd features;
  std::vector<int> directions;
  Eigen::VectorXd residual;
  Eigen::VectorXd noise_variance;
};

// Every so many rows of all but one trial; fewer rows with more noise would be the same as averaging, so that each
// keeps the noise that it has.
Rows training_rows(const Observations& observations, const Eigen::MatrixXd& features, const Eigen::VectorXd& residual,
                   int without_trial) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    if (observations.trial[static_cast<std::size_t>(row)] != without_trial) rows.push_back(row);
  }
  const std::size_t stride = 1 + rows.size() / static_cast<std::size_t>(maximum_correction_rows);
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < rows.size(); i += stride) kept.push_back(rows[i]);
  Rows training{features(kept, Eigen::all), {}, residual(kept), observations.noise(kept).array().square()};
  for (const Eigen::Index row : kept)
    training.directions.push_back(observations.direction[static_cast<std::size_t>(row)]);
  return training;
}

Eigen::VectorXd correction_at(const SmoothCorrection& smooth, const Eigen::MatrixXd& features,
                              const std::vector<int>& directions) {
  return kernel(scaled(smooth, features), directions, scaled(smooth, smooth.features), smooth.directions) *
         smooth.weights;
}

SmoothCorrection trained(const Observations& observations, const Eigen::MatrixXd& features,
                         const Eigen::VectorXd& residual, double length_scale, int without_trial) {
  Rows rows = training_rows(observations, features, residual, without_trial);
  SmoothCorrection smooth;
  smooth.center = features.colwise().mean();
  smooth.spread = ((features.rowwise() - smooth.center).colwise().squaredNorm() / double(features.rows())).cwiseSqrt();
  smooth.spread = smooth.spread.unaryExpr([](double spread) { return spread > 1e-12 ? spread : 1.0; });
  smooth.length_scale = length_scale;
  smooth.features = std::move(rows.features);
  smooth.directions = std::move(rows.directions);
  // Each direction has the variance of its own residual, which may be volts beside degrees.
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(observations.directions.size()));
  Eigen::VectorXd count = variance;
  for (Eigen::Index i = 0; i < rows.residual.size(); ++i) {
    variance[smooth.directions[static_cast<std::size_t>(i)]] += rows.residual[i] * rows.residual[i];
    count[smooth.directions[static_cast<std::size_t>(i)]] += 1;
  }
  variance = variance.cwiseQuotient(count.cwiseMax(1));
  const Eigen::MatrixXd here = scaled(smooth, smooth.features);
  Eigen::MatrixXd covariance = kernel(here, smooth.directions, here, smooth.directions);
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    const double own = std::max(variance[smooth.directions[static_cast<std::size_t>(i)]], 1e-30);
    covariance(i, i) += rows.noise_variance[i] / own + 1e-6;
  }
  smooth.weights = covariance.llt().solve(rows.residual);
  return smooth;
}

}  // namespace

Eigen::MatrixXd features_of(const Observations& observations) {
  const Eigen::Index places = observations.has_places() ? 3 : 0;
  Eigen::MatrixXd features(observations.rows(), 1 + places + observations.conditions.cols());
  features.col(0) = observations.load;
  if (places > 0) features.middleCols(1, places) = observations.place_mm;
  if (observations.conditions.cols() > 0) features.rightCols(observations.conditions.cols()) = observations.conditions;
  return features;
}

Eigen::VectorXd correction(const SmoothCorrection& smooth, const Observations& observations) {
  return correction_at(smooth, features_of(observations), observations.direction);
}

std::optional<CorrectionFit> fit_smooth_correction(const Observations& observations, const Eigen::VectorXd& residual,
                                                   const Progress& progress) {
  if (observations.trial_count() < 3) return std::nullopt;
  const Eigen::MatrixXd features = features_of(observations);
  const auto sum_of_squares = [&](const Eigen::VectorXd& values) {
    return values.cwiseQuotient(observations.noise).squaredNorm();
  };
  std::optional<CorrectionFit> best;
  double minimum = worth_having * sum_of_squares(residual);
  for (const double length_scale : {0.3, 0.6, 1.2, 2.5, 5.0}) {
    Eigen::VectorXd held_out(observations.rows());
    int improved = 0;
    for (int trial = 0; trial < observations.trial_count(); ++trial) {
      if (progress.cancelled()) return std::nullopt;
      std::vector<Eigen::Index> left_out;
      std::vector<int> directions;
      for (Eigen::Index row = 0; row < observations.rows(); ++row) {
        if (observations.trial[static_cast<std::size_t>(row)] != trial) continue;
        left_out.push_back(row);
        directions.push_back(observations.direction[static_cast<std::size_t>(row)]);
      }
      const SmoothCorrection without = trained(observations, features, residual, length_scale, trial);
      held_out(left_out) = correction_at(without, features(left_out, Eigen::all), directions);
      const Eigen::VectorXd noise = observations.noise(left_out);
      const Eigen::VectorXd alone = residual(left_out);
      const Eigen::VectorXd corrected = alone - Eigen::VectorXd(held_out(left_out));
      if (corrected.cwiseQuotient(noise).squaredNorm() < alone.cwiseQuotient(noise).squaredNorm()) ++improved;
    }
    const bool mostly = 3 * improved >= 2 * observations.trial_count();
    if (const double sum = sum_of_squares(residual - held_out); mostly && sum < minimum) {
      minimum = sum;
      best = CorrectionFit{trained(observations, features, residual, length_scale, -1), std::move(held_out)};
    }
  }
  return best;
}

}  // namespace glisson::closedloop
