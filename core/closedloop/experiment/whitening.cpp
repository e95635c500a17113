#include "closedloop/experiment/whitening.h"

#include <algorithm>
#include <Eigen/Eigenvalues>
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
  // With A for U scaled by the rest and A^T A = P S^2 P^T, the inverse square root of 1 + A A^T is 1 - B B^T where
  // B = A P (r (r + 1))^-1/2 and r = (1 + S^2)^1/2. Nothing is divided by S, which may be zero.
  Eigen::MatrixXd scaled = inverse_noise_.asDiagonal() * systematic.directions(rows_, Eigen::all);
  leave_groups_out(scaled);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(scaled.transpose() * scaled);
  const Eigen::ArrayXd root = (1 + gram.eigenvalues().array().max(0)).sqrt();
  directions_ = scaled * gram.eigenvectors() * (root * (root + 1)).rsqrt().matrix().asDiagonal();
}

Eigen::MatrixXd Whitening::whiten(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd white = inverse_noise_.asDiagonal() * columns(rows_, Eigen::all);
  leave_groups_out(white);
  if (directions_.cols() > 0) white -= directions_ * (directions_.transpose() * white).eval();
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
