#pragma once
// What speaks for a set of effects. It is how well it fits for the freedom that it takes (BIC), and how well it
// predicts trials that it was not fitted to.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"
#include "closedloop/inference/fit.h"

namespace glisson::closedloop {

// n rows count as n / correlation, where neighbours in time repeat each other. Noise is at least as large as stated,
// and as large as the fit leaves it where that is more. So a poor fit does not make small gains look certain:
//   BIC = m ln s2 + m (chi2 / n) / s2 + k ln m,   m = n / correlation, s2 = max(1, chi2 / n)
// (Schwarz 1978; with the variance profiled and bounded below.)
[[nodiscard]] double bic(double chi2, Eigen::Index rows, Eigen::Index parameters, double correlation);

// The ways in which trials are left out whole: each by itself, and the one under the largest load.
class CrossValidationFolds {
 public:
  explicit CrossValidationFolds(const ForwardModel& model, const EvidenceOptions& options = {});

  struct Fold {
    Whitening kept;
    Whitening left_out;
  };
  [[nodiscard]] const std::vector<Fold>& trials() const { return trials_; }  // none for a single trial
  [[nodiscard]] const std::optional<Fold>& largest_load() const { return largest_load_; }
  [[nodiscard]] bool any() const { return !trials_.empty(); }

 private:
  std::vector<Fold> trials_;
  std::optional<Fold> largest_load_;
};

// What the trials say that were left out, each predicted from the others: to first order about the fit to all of them.
struct LeftOut {
  Eigen::VectorXd predicted;  // of each row by the model that did not see its trial; the fit's own for one trial
  double chi2 = 0;            // whitened trial by trial
  // False where the others do not predict a trial: a law that follows all of them, and is open or without a solution
  // beyond the rest. Then chi2 is infinite, and `predicted` no prediction.
  bool given = true;
};
[[nodiscard]] LeftOut leave_out(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds);

// Chi-squared of the same trials where nothing is predicted at all, by zeros: a model that does worse there says
// nothing.
[[nodiscard]] double left_out_by_zeros(const ForwardModel& model, const CrossValidationFolds& folds);

// How much of an error of this shape the residual shows over these rows. Its size is known roughly, so the share goes
// from none to one and a half. It is none where BIC says that it does not pay.
[[nodiscard]] double share_of(const Eigen::VectorXd& expected, const Eigen::VectorXd& residual,
                              const Eigen::VectorXd& noise, const std::vector<Eigen::Index>& rows,
                              const EvidenceOptions& options = {});

// The same with a new fit for each trial.
Result<LeftOut> leave_out_with_refits(const ForwardModel& model, const Fit& fit, const CrossValidationFolds& folds,
                                      const EvidenceOptions& options = {}, const Progress& progress = {});

// Chi-squared of the trials under the largest load, predicted by a fit to the others that begins at `fit`. Nothing
// where all trials go about as far, or where that fit fails.
[[nodiscard]] std::optional<double> largest_load_chi2(const ForwardModel& model, const Fit& fit,
                                                      const CrossValidationFolds& folds,
                                                      const EvidenceOptions& options = {},
                                                      const Progress& progress = {});

// Error with a 95 % interval from resamplings of the trials.
[[nodiscard]] HeldOut held_out_error(const Observations& observations, const Eigen::VectorXd& predicted,
                                     const EvidenceOptions& options = {});

// Parameters refitted, to first order, to resamplings of the trials: a column each.
[[nodiscard]] Eigen::MatrixXd bootstrapped_parameters(const ForwardModel& model, const Fit& fit,
                                                      const Whitening& whitening, const EvidenceOptions& options = {});

}  // namespace glisson::closedloop
