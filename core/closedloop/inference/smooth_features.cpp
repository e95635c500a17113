#include "closedloop/inference/smooth_features.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "closedloop/inference/smooth_correction.h"

namespace glisson::closedloop {
namespace {

Eigen::MatrixXd features_with_history(const Observations& observations);

}  // namespace

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

}  // namespace
}  // namespace glisson::closedloop
