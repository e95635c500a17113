#pragma once
// A smooth correction of what no known effect explains. It is a Gaussian process on load, place and the other
// conditions, one for each direction with shared shape. It claims no cause; it is offered only where it predicts trials
// that were left out whole better than doing without.
//
// Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), ch. 2; kernel exp(-d^2 / 2), d in length
// scales.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "closedloop/experiment/observations.h"

namespace glisson::closedloop {

struct SmoothCorrection {
  Eigen::RowVectorXd center;  // of the features, and
  Eigen::RowVectorXd spread;  // their standard deviations; after scaling with these:
  double length_scale = 1;
  Eigen::MatrixXd features;     // of the rows it rests on
  std::vector<int> directions;  // of those rows
  Eigen::VectorXd weights;      // one a row: correction = kernel(here, features) * weights, of equal direction
};

// The features of all rows: load, place, conditions.
[[nodiscard]] Eigen::MatrixXd features_of(const Observations& observations);

// In the units of the measurements, a number a row of the observations.
[[nodiscard]] Eigen::VectorXd correction(const SmoothCorrection& smooth, const Observations& observations);

struct CorrectionFit {
  SmoothCorrection smooth;
  Eigen::VectorXd held_out;  // the correction of each row from the other trials alone
};

// Fitted to `residual` (measured - predicted). Nothing where there are fewer than three trials, or where no length
// scale makes left-out trials better. Better means that the sum of squares over them, in units of the noise, is at
// least a tenth smaller in all. It must be smaller in two trials of three, too.
[[nodiscard]] std::optional<CorrectionFit> fit_smooth_correction(const Observations& observations,
                                                                 const Eigen::VectorXd& residual,
                                                                 const Progress& progress = {});

}  // namespace glisson::closedloop
