#include "registration_quality/internal/warp.h"

#include <algorithm>

namespace glisson::registration_quality {

using Eigen::Vector3d;

SharedCentreWarps::SharedCentreWarps(std::vector<Vector3d> centres_mm, const Eigen::MatrixXd& displacements_mm,
                                     double stiffness_mm)
    : centres_mm_(std::move(centres_mm)), center_mm_(Vector3d::Zero()), size_mm_(0) {
  const auto count = static_cast<Eigen::Index>(centres_mm_.size());
  for (const Vector3d& centre : centres_mm_) center_mm_ += centre / static_cast<double>(count);
  for (const Vector3d& centre : centres_mm_) size_mm_ = std::max(size_mm_, (centre - center_mm_).norm());
  Eigen::MatrixXd system(count + 4, count + 4);
  system.topRows(count) = kernel_rows(centres_mm_);
  system.diagonal().head(count).array() -= stiffness_mm / size_mm_;
  system.bottomLeftCorner(4, count) = system.topRightCorner(count, 4).transpose();
  // Centres may lie in one plane, where the part across it is not determined: held near zero.
  system.bottomRightCorner(4, 4) = 1e-9 * Eigen::Matrix4d::Identity();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count + 4, displacements_mm.cols());
  right.topRows(count) = displacements_mm;
  coefficients_ = system.partialPivLu().solve(right);
}

Eigen::MatrixXd SharedCentreWarps::displacements_mm(const std::vector<Vector3d>& points_mm) const {
  return kernel_rows(points_mm) * coefficients_;
}

// Distances to the centres, then the affine part; in units of the centres' spread, which conditions the system.
Eigen::MatrixXd SharedCentreWarps::kernel_rows(const std::vector<Vector3d>& points_mm) const {
  const auto count = static_cast<Eigen::Index>(centres_mm_.size());
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points_mm.size()), count + 4);
  for (Eigen::Index centre = 0; centre < count; ++centre) {
    const Vector3d& at = centres_mm_[static_cast<std::size_t>(centre)];
    for (std::size_t point = 0; point < points_mm.size(); ++point) {
      rows(static_cast<Eigen::Index>(point), centre) = (points_mm[point] - at).norm() / size_mm_;
    }
  }
  for (std::size_t point = 0; point < points_mm.size(); ++point) {
    rows.row(static_cast<Eigen::Index>(point)).tail<4>() << 1, ((points_mm[point] - center_mm_) / size_mm_).transpose();
  }
  return rows;
}

}  // namespace glisson::registration_quality
