#pragma once
// A linear fit with two sorts of unknowns: free ones, and ones that are zero but for a variance that the data choose.
//
//   rows = free x + modes w + noise,   w ~ N(0, variance),   noise ~ N(0, kappa)
//
// The variance is that of the largest evidence (type-II maximum likelihood; Bishop, Pattern Recognition and Machine
// Learning, 3.5), searched over a grid up to a largest one. Rows repeat each other: as many count as are independent,
// each as much as any other, or each by the weight that it brings.

#include <Eigen/Core>

namespace glisson::guidance {

struct EvidenceFit {
  double variance = 0;      // of each mode's amount
  double kappa = 1;         // the noise found, over the noise stated, squared
  double log_evidence = 0;  // but for a constant of the number of rows
  Eigen::VectorXd modes;    // the amounts w
  Eigen::VectorXd free;
  Eigen::MatrixXd precision;  // of (w, x), the free ones last, but for kappa
  double log_occam = 0;       // half the log determinant of the precision over that before the rows, but for a constant
                              // of the free unknowns' own

  // Inverts the precision: for the last of many fits.
  [[nodiscard]] Eigen::MatrixXd covariance() const;
};

// `rows`, `modes` and `free` are divided by each row's stated noise.
[[nodiscard]] EvidenceFit fit_by_evidence(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free,
                                          const Eigen::VectorXd& rows, double independent_rows,
                                          double largest_variance);

// The same of rows that are weighed down already, where they repeat each other: they amount to `count`.
[[nodiscard]] EvidenceFit fit_weighed_by_evidence(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free,
                                                  const Eigen::VectorXd& rows, double count, double largest_variance);

// By how much the log evidence of such a fit would grow with three more unknowns of unit variance each. There is one
// gain for every three columns of `further`, which stand beside those that were fitted.
[[nodiscard]] Eigen::VectorXd evidence_gains(const EvidenceFit& fit, const Eigen::MatrixXd& modes,
                                             const Eigen::MatrixXd& free, const Eigen::VectorXd& rows,
                                             const Eigen::MatrixXd& further);

}  // namespace glisson::guidance
