#pragma once
// Which further trial would tell most about what is right: the information that its measurement is expected to give
// about which explanation holds.
//
//   I(K; Y) = H(K) - E_Y [H(K | Y)],   Y given k ~ N(f_k, 1 + S_k S_k^T)
//
// k: an explanation with its probability; f_k what it predicts, in deviations: the noise and what the declared model's
// own prediction may be off by. S_k S_k^T what the parameters, as far as the measurements leave them open, spread that
// by, to first order. By Monte Carlo over k and Y.
// Lindley 1956, Ann. Math. Stat. 27:986; Chaloner and Verdinelli 1995, Stat. Sci. 10:273.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"
#include "closedloop/inference/posterior.h"

namespace glisson::closedloop {

// A normal distribution over what a trial would measure: rows, and rows x parameters.
struct ExpectedMeasurement {
  Eigen::VectorXd mean;
  Eigen::MatrixXd spread;
};

// Natural logarithms. `expected`: one an explanation, all of as many rows; `probability` adds up to 1. The same draws
// each time. Never negative.
[[nodiscard]] double expected_information(const std::vector<double>& probability,
                                          const std::vector<ExpectedMeasurement>& expected, int draws);

// Of the model's further trials those to make, one after the other, each given those before it. Each has the largest
// expected information about which of the likeliest explanations holds. Of about as good ones it is the simplest.
// "Something else" predicts what the likeliest does, but what that changes is off by a factor of its own in each trial
// (deviation 1): a trial that puts a known cause to a severe test lessens that doubt.
// None is to be made where no trial would lessen the doubt; both lists are empty where there is none
// (NextTrialOptions). Fails when cancelled; a trial or an explanation that cannot be solved is passed over.
Result<NextTrials> next_trials(const Weighing& weighing, const Posterior& posterior, const DiagnosisOptions& options,
                               const Progress& progress = {});

}  // namespace glisson::closedloop
