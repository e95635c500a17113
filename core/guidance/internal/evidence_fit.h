#pragma once
// A linear fit with two sorts of unknowns: free ones, and ones that are zero but for a variance that the data choose.
//
//   rows = free x + modes w + noise,   w ~ N(0, variance),   noise ~ N(0, kappa)
//
// The variance is that of the largest evidence (type-II maximum likelihood; Bishop, Pattern Recognition and Machine
// Learning, 3.5), searched over a grid up to a largest one. Rows repeat each other: as many count as are independent.
// Inside of this room.

#include <Eigen/Core>

namespace glisson::guidance {

struct EvidenceFit {
  double variance = 0;      // of each mode's amount
  double kappa = 1;         // the noise found, over the noise stated, squared
  double log_evidence = 0;  // but for a constant of the number of rows
  Eigen::VectorXd modes;    // the amounts w
  Eigen::VectorXd free;
  Eigen::MatrixXd precision;  // of (w, x), the free ones last, but for kappa

  // Inverts the precision: for the last of many fits.
  [[nodiscard]] Eigen::MatrixXd covariance() const;
};

// `rows`, `modes` and `free` are divided by each row's stated noise.
[[nodiscard]] EvidenceFit fit_by_evidence(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& free,
                                          const Eigen::VectorXd& rows, double independent_rows,
                                          double largest_variance);

}  // namespace glisson::guidance
