#pragma once
// Residuals in units of what is to be expected of them: independent noise of each number, and directions in which the
// prediction itself may be off (ForwardModel::systematic_uncertainty). With covariance C = N^2 + U U^T, N the noise and
// U the directions, whiten() multiplies with a square root of C^-1, so that what it gives is white with variance 1
// where the model is right.

#include <Eigen/Core>
#include <vector>

namespace glisson::closedloop {

class Whitening {
 public:
  // Over the rows named; `systematic` has a row for each number and may have no columns.
  Whitening(const Eigen::VectorXd& noise, const Eigen::MatrixXd& systematic, std::vector<Eigen::Index> rows);

  [[nodiscard]] const std::vector<Eigen::Index>& rows() const { return rows_; }

  // Of vectors (columns) over all rows of the experiment; gives the rows named alone.
  [[nodiscard]] Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;

 private:
  std::vector<Eigen::Index> rows_;
  Eigen::VectorXd inverse_noise_;  // of the rows named
  Eigen::MatrixXd directions_;     // orthonormal columns, of the noise-scaled systematic uncertainty
  Eigen::VectorXd shrinking_;      // 1 - 1 / sqrt(1 + s^2), s the size along each direction in units of the noise
};

}  // namespace glisson::closedloop
