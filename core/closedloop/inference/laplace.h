#pragma once
// The evidence of a set of effects: how probable the measurements are, whatever its parameters and the noise's true
// size may be. Each value of these is weighed by what was believed of it before (PosteriorOptions). Parameters by
// Laplace's method about a fit, the size of the noise by quadrature.
//
// MacKay, Information Theory, Inference, and Learning Algorithms (2003), ch. 27 and 28; Kass and Raftery 1995, J. Am.
// Stat. Assoc. 90:773, 4.1.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/fit.h"

namespace glisson::closedloop {

// Chi-squared about a fit, to second order: all that its evidence needs.
struct LocalFit {
  Settings settings;
  double chi2 = 0;
  Eigen::Index rows = 0;
  Eigen::VectorXd downhill;     // J^T C^-1 r, a number a parameter: how chi-squared / 2 falls
  Eigen::MatrixXd information;  // J^T C^-1 J
};

// Of a search that was stopped before its end nothing is predicted: it counts as if it had ended there.
[[nodiscard]] LocalFit local_fit(const Fit& fit, const Whitening& whitening);

// The parameters' prior: independent normals within bounds, over logarithms of logarithmic parameters.
struct ParameterPrior {
  Eigen::VectorXd center, spread;  // of each parameter, or of its logarithm
  Eigen::VectorXd lower, upper;    // bounds, in deviations from the center
  std::vector<Scale> scales;

  [[nodiscard]] Eigen::VectorXd inward(const Eigen::VectorXd& values) const;  // in deviations from the center
  [[nodiscard]] Eigen::VectorXd outward(const Eigen::VectorXd& deviations) const;
  [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& values) const;  // d value / d deviation
};
[[nodiscard]] ParameterPrior prior_of(const ForwardModel& model, const Settings& settings,
                                      const PosteriorOptions& options);

// That the noise is so many times as large as stated, over the factor's logarithm: the density's natural logarithm, and
// how that changes.
struct LogDensity {
  double value = 0;
  double slope = 0;
};
[[nodiscard]] LogDensity log_density_of_noise_scale(double log_scale, const PosteriorOptions& options);

// Natural logarithms. n rows count as n / correlation, where neighbours repeat each other. What all models of the same
// rows share is left out: (2 pi)^(-m/2) and the stated noise.
struct LogEvidence {
  double evidence = 0;
  double best = 0;  // of the fit's parameters alone, as if they had been known
};
[[nodiscard]] LogEvidence log_evidence(const ForwardModel& model, const LocalFit& fit, double correlation,
                                       const PosteriorOptions& options);

// Moved to the maximum of the posterior by Gauss and Newton's steps, for models that predict quickly; where a step
// fails, as far as it came.
[[nodiscard]] LocalFit at_maximum(const ForwardModel& model, const Whitening& whitening, LocalFit fit,
                                  double correlation, const PosteriorOptions& options, const Progress& progress = {});

}  // namespace glisson::closedloop
