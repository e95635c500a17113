#pragma once
// Parameters of switched-on effects from the measurements, by weighted least squares within their bounds.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/experiment/whitening.h"

namespace glisson::closedloop {

struct FitOptions {
  int maximum_iterations = 30;       // Levenberg-Marquardt; smooth problems of few parameters need about ten
  double relative_tolerance = 1e-4;  // of chi-squared: far below what a change in evidence means
};

struct Fit {
  Settings settings;
  Eigen::VectorXd predicted;    // all rows, also of trials that were not fitted
  Eigen::MatrixXd derivatives;  // of predicted, a column a parameter
  Eigen::VectorXd white;        // whitened residual of the rows that were fitted
  double chi2 = 0;              // its square
  bool converged = true;        // false: stopped by the limit of iterations
};

// The declared model, or any settings, as they are.
Result<Fit> without_fitting(const ForwardModel& model, const Settings& settings, const Whitening& whitening);

// From `start`, over the rows of `whitening`. Fails ("fit-failed") where the model cannot be solved at the start.
Result<Fit> fit(const ForwardModel& model, const Settings& start, const Whitening& whitening,
                const FitOptions& options = {}, const Progress& progress = {});

// How the parameters of `fit` would change, to first order, if the rows of `whitening` alone were measured: (J^T C^-1
// J)^-1 J^T C^-1 r over these rows. Directions that the rows do not determine stay as they are.
[[nodiscard]] Eigen::VectorXd first_order_change(const Fit& fit, const Eigen::VectorXd& measured,
                                                 const Whitening& whitening);

// Covariance of the parameters for noise as stated. Directions without information have the variance of `widest`
// (a standard deviation a parameter).
[[nodiscard]] Eigen::MatrixXd covariance(const Eigen::MatrixXd& white_derivatives, const Eigen::VectorXd& widest);

// Rows of the trials whose flag is set.
[[nodiscard]] std::vector<Eigen::Index> rows_of(const Observations& observations, const std::vector<bool>& trials);
[[nodiscard]] std::vector<Eigen::Index> all_rows(const Observations& observations);

// Bounds and prior widths of all parameters of the settings, one after the other.
struct ParameterRanges {
  Eigen::VectorXd lower, upper, prior_width;
  std::vector<Scale> scales;
  std::vector<std::string> names;
};
[[nodiscard]] ParameterRanges ranges_of(const ForwardModel& model, const Settings& settings);
[[nodiscard]] Eigen::VectorXd values_of(const Settings& settings);
[[nodiscard]] Settings with_values(Settings settings, const Eigen::VectorXd& values);

}  // namespace glisson::closedloop
