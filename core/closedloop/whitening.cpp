#include "closedloop/whitening.h"

#include <Eigen/SVD>
#include <utility>

namespace glisson::closedloop {

Whitening::Whitening(const Eigen::VectorXd& noise, const Eigen::MatrixXd& systematic, std::vector<Eigen::Index> rows)
    : rows_(std::move(rows)), inverse_noise_(noise(rows_).cwiseInverse()) {
  if (systematic.cols() == 0 || rows_.empty()) return;
  // U scaled by the noise is Q S P^T, so N^-1 C N^-1 = 1 + Q S^2 Q^T, whose inverse square root leaves everything
  // outside Q as it is.
  const Eigen::MatrixXd scaled = inverse_noise_.asDiagonal() * systematic(rows_, Eigen::all);
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU);
  directions_ = svd.matrixU();
  shrinking_ = 1 - (1 + svd.singularValues().array().square()).rsqrt();
}

Eigen::MatrixXd Whitening::whiten(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd white = inverse_noise_.asDiagonal() * columns(rows_, Eigen::all);
  if (directions_.cols() > 0) {
    const Eigen::MatrixXd along = shrinking_.asDiagonal() * (directions_.transpose() * white);
    white -= directions_ * along;
  }
  return white;
}

}  // namespace glisson::closedloop
