#include "closedloop/experiment/whitening.h"

#include <algorithm>
#include <Eigen/SVD>
#include <utility>

namespace glisson::closedloop {

Whitening::Whitening(const Eigen::VectorXd& noise, const SystematicUncertainty& systematic,
                     std::vector<Eigen::Index> rows)
    : rows_(std::move(rows)), inverse_noise_(noise(rows_).cwiseInverse()) {
  if (rows_.empty()) return;
  if (systematic.shared.size() > 0) {
    groups_.resize(1 + static_cast<std::size_t>(*std::max_element(systematic.group.begin(), systematic.group.end())));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      groups_[static_cast<std::size_t>(systematic.group[static_cast<std::size_t>(rows_[i])])].rows.push_back(
          static_cast<Eigen::Index>(i));
    for (Group& group : groups_) {
      group.direction = inverse_noise_.cwiseProduct(systematic.shared(rows_))(group.rows);
      const double size = group.direction.norm();
      if (size > 0) group.direction /= size;
      group.shrinking = 1 - 1 / std::sqrt(1 + size * size);
    }
    std::erase_if(groups_, [](const Group& group) { return group.shrinking == 0; });
  }
  if (systematic.directions.cols() == 0) return;
  // U scaled by the rest is Q S P^T, so the scaled C is 1 + Q S^2 Q^T, whose inverse square root leaves everything
  // outside Q as it is.
  Eigen::MatrixXd scaled = inverse_noise_.asDiagonal() * systematic.directions(rows_, Eigen::all);
  leave_groups_out(scaled);
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU);
  directions_ = svd.matrixU();
  shrinking_ = 1 - (1 + svd.singularValues().array().square()).rsqrt();
}

Eigen::MatrixXd Whitening::whiten(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd white = inverse_noise_.asDiagonal() * columns(rows_, Eigen::all);
  leave_groups_out(white);
  if (directions_.cols() > 0) {
    const Eigen::MatrixXd along = shrinking_.asDiagonal() * (directions_.transpose() * white);
    white -= directions_ * along;
  }
  return white;
}

void Whitening::leave_groups_out(Eigen::MatrixXd& white) const {
  for (const Group& group : groups_) {
    for (Eigen::Index c = 0; c < white.cols(); ++c) {
      double along = 0;
      for (Eigen::Index i = 0; i < group.direction.size(); ++i)
        along += group.direction[i] * white(group.rows[static_cast<std::size_t>(i)], c);
      for (Eigen::Index i = 0; i < group.direction.size(); ++i)
        white(group.rows[static_cast<std::size_t>(i)], c) -= group.shrinking * along * group.direction[i];
    }
  }
}

}  // namespace glisson::closedloop
