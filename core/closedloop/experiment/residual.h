#pragma once
// Is what a model leaves noise? Tests, each with a probability, for what independent noise of the stated size would not
// do. All assume that the noise is normal and known to within a twentieth.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "closedloop/experiment/observations.h"

namespace glisson::closedloop {

// In the experiment's unit; over rows (rms) and over the vectors that rows make (mean, p95, max: for markers their
// three coordinates together).
struct ErrorFigures {
  double rms = 0;
  double mean = 0;
  double p95 = 0;
  double max = 0;
  double noise = 0;  // root mean square of the stated noise
  double reduced_chi2 = 0;
  // In each direction's own unit; only where `unit` is "noise", and there nothing for a direction without rows.
  std::vector<std::optional<double>> rms_of_direction;
};

// Rows whose measurement is NaN are left out.
[[nodiscard]] ErrorFigures error_figures(const Observations& observations, const Eigen::VectorXd& predicted);

// A residual is noise when no test, all tests taken together, is more improbable than this;
inline constexpr double improbable_for_noise = 1e-3;
// the noise may be so many times as large as stated.
inline constexpr double noise_is_known_to = 1.05;

struct NoiseTest {
  std::string name;      // "size", "quantity", "neighbours", "load", "time", "place", "direction", "trials", "scale"
  std::string sentence;  // what it says where it is significant
  double statistic = 0;
  double p_value = 1;
  double degrees = 0;  // of freedom, where `statistic` is a sum of so many squares; else 0
};

struct ResidualDiagnostics {
  std::vector<NoiseTest> tests;
  double smallest_p = 1;  // of all tests, times their number (Bonferroni)
  bool is_noise = true;
  // In words, the features that noise would not have, the strongest first; empty for noise.
  [[nodiscard]] std::vector<std::string> shape() const;
};

// `white`: the whitened residual (whitening.h), a number a row; `predicted` in the experiment's unit.
//   size        sum of squares against chi-squared, with noise 1.05 times the stated one;
//   quantity    the same of each of Observations::quantities, the most improbable: a few forces beside many points;
//   neighbours  Moran's I over the nearest markers of the same moment; without places, over neighbours in time;
//   others      score tests: the part of the residual along a few functions of the covariate, against chi-squared.
// A residual is noise when no test is as improbable as one in a thousand, all tests taken together.
[[nodiscard]] ResidualDiagnostics residual_diagnostics(const Observations& observations, const Eigen::VectorXd& white,
                                                       const Eigen::VectorXd& predicted);

// In noises, the root mean square of the quantity that is farthest off (Observations::quantities), over what chance may
// add to so few rows, three standard deviations. 0 where all rows are judged as one.
[[nodiscard]] double rms_of_worst_quantity(const Observations& observations, const Eigen::VectorXd& white);

// How many neighbouring rows in time repeat each other, at least 1. It is 1 + 2 sum of autocorrelations within trials
// and directions, up to the first below 0.05. So n rows are worth n over this.
[[nodiscard]] double correlation_length(const Observations& observations, const Eigen::VectorXd& white);

// How many times as large as stated the noise is, where it cannot be as stated. It is read from second differences in
// time, by their median, so that few wild values count for nothing. A residual that is smooth or repeats itself can
// only make them smaller. So a noise that seems smaller must be so in all of the residual too. Nothing where there is
// no history of 30 samples.
[[nodiscard]] std::optional<double> impossible_noise(const Observations& observations, const Eigen::VectorXd& residual);

}  // namespace glisson::closedloop
