#include "guidance/internal/evidence_fit.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <limits>

#include "base/dense.h"

namespace glisson::guidance {
namespace {

constexpr double smallest_variance = 1e-3;  // mm^2: as good as rigid
constexpr int variances_per_decade = 4;

struct Chosen {
  double log_evidence = -std::numeric_limits<double>::infinity();
  double variance = smallest_variance;
  double kappa = 1;
};

// Of `count` rows, each of which is a `share` of an independent one.
EvidenceFit fitted(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free, const Eigen::VectorXd& rows, double count,
                   double share, double largest_variance) {
  // The free unknowns are projected out; what is left decides on the modes alone.
  const Eigen::MatrixXd gram_free = free.transpose() * free;
  const Eigen::MatrixXd inverse_free = dense_inverse(gram_free);
  const Eigen::MatrixXd cross = free.transpose() * modes;
  const Eigen::VectorXd free_rows = free.transpose() * rows;
  const Eigen::MatrixXd gram_modes = modes.transpose() * modes;
  const Eigen::MatrixXd gram = gram_modes - cross.transpose() * inverse_free * cross;
  const Eigen::VectorXd gradient = modes.transpose() * rows - cross.transpose() * (inverse_free * free_rows);
  const double square = rows.squaredNorm() - free_rows.dot(inverse_free * free_rows);
  const SymmetricModes spectrum = symmetric_modes(gram);
  const Eigen::ArrayXd values = spectrum.values.array().max(0.0);
  const Eigen::ArrayXd along = (spectrum.vectors.transpose() * gradient).array();

  Chosen best;
  for (int step = 0;; ++step) {
    const double variance = smallest_variance * std::pow(10.0, static_cast<double>(step) / variances_per_decade);
    if (variance > std::max(largest_variance, smallest_variance)) break;
    const double left = std::max(1e-12, square - (along.square() * variance / (1 + variance * values)).sum());
    const double log_evidence =
        -0.5 * share * count * std::log(left / count) - 0.5 * (1 + variance * share * values).log().sum();
    if (log_evidence > best.log_evidence) best = {log_evidence, variance, left / count};
  }

  EvidenceFit fit{best.variance, best.kappa, best.log_evidence, {}, {}, {}, 0};
  const Eigen::ArrayXd shrunk = best.variance / (1 + best.variance * values);
  fit.modes = spectrum.vectors * (shrunk * along).matrix();
  fit.free = inverse_free * (free_rows - cross * fit.modes);
  fit.log_occam = 0.5 * ((1 + best.variance * share * values).log().sum() +
                         symmetric_modes(gram_free).values.array().max(1e-300).log().sum());
  const Eigen::Index q = modes.cols(), all = q + free.cols();
  fit.precision.resize(all, all);
  fit.precision.topLeftCorner(q, q) = share * gram_modes;
  fit.precision.topLeftCorner(q, q).diagonal().array() += 1 / best.variance;
  fit.precision.bottomLeftCorner(free.cols(), q) = share * cross;
  fit.precision.topRightCorner(q, free.cols()) = share * cross.transpose();
  fit.precision.bottomRightCorner(free.cols(), free.cols()) = share * gram_free;
  return fit;
}

}  // namespace

EvidenceFit fit_by_evidence(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free, const Eigen::VectorXd& rows,
                            double independent_rows, double largest_variance) {
  const double count = std::max<double>(1.0, static_cast<double>(rows.size() - free.cols()));
  return fitted(modes, free, rows, count, std::min(1.0, independent_rows / count), largest_variance);
}

EvidenceFit fit_weighed_by_evidence(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free,
                                    const Eigen::VectorXd& rows, double count, double largest_variance) {
  return fitted(modes, free, rows, std::max(1.0, count), 1.0, largest_variance);
}

Eigen::VectorXd evidence_gains(const EvidenceFit& fit, const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free,
                               const Eigen::VectorXd& rows, const Eigen::MatrixXd& further) {
  Eigen::MatrixXd fitted(rows.size(), modes.cols() + free.cols());
  fitted << modes, free;
  const Eigen::MatrixXd cross = fitted.transpose() * further;
  const Eigen::MatrixXd solved = dense_inverse(fit.precision) * cross;
  const Eigen::VectorXd left = rows - modes * fit.modes - free * fit.free;
  Eigen::VectorXd gains(further.cols() / 3);
  for (Eigen::Index k = 0; k < gains.size(); ++k) {
    const auto columns = further.middleCols<3>(3 * k);
    const Eigen::Matrix3d seen =
        (columns.transpose() * columns - cross.middleCols<3>(3 * k).transpose() * solved.middleCols<3>(3 * k)) /
        fit.kappa;
    const Eigen::Vector3d pull = columns.transpose() * left / fit.kappa;
    const Eigen::Matrix3d precision = Eigen::Matrix3d::Identity() + seen;
    gains[k] = 0.5 * pull.dot(precision.inverse() * pull) - 0.5 * std::log(precision.determinant());
  }
  return gains;
}

Eigen::MatrixXd EvidenceFit::covariance() const { return kappa * dense_inverse(precision); }

}  // namespace glisson::guidance
