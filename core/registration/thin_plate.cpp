#include "registration/thin_plate.h"

#include <algorithm>
#include <Eigen/LU>
#include <Eigen/QR>
#include <map>

namespace glisson::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t maximum_knots = 6000;  // 0.3 GB, and some ten seconds

struct PointOrder {
  bool operator()(const Vector3d& a, const Vector3d& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

void merge_duplicates(std::vector<Vector3d>& from_mm, std::vector<Vector3d>& to_mm) {
  std::map<Vector3d, std::pair<Vector3d, int>, PointOrder> sums;
  for (std::size_t i = 0; i < from_mm.size(); ++i) {
    auto& [sum, count] = sums.try_emplace(from_mm[i], Vector3d::Zero(), 0).first->second;
    sum += to_mm[i];
    ++count;
  }
  from_mm.clear();
  to_mm.clear();
  for (const auto& [point, target] : sums) {
    from_mm.push_back(point);
    to_mm.push_back(target.first / target.second);
  }
}

}  // namespace

Result<ThinPlateSpline> ThinPlateSpline::fit(std::vector<Vector3d> from_mm, std::vector<Vector3d> to_mm,
                                             double stiffness_mm) {
  const auto finite = [](const Vector3d& point) { return point.allFinite(); };
  if (from_mm.size() != to_mm.size() || !std::all_of(from_mm.begin(), from_mm.end(), finite) ||
      !std::all_of(to_mm.begin(), to_mm.end(), finite)) {
    return failure("spline-sizes", GLISSON_TEXT("A spline needs as many finite points to start from as to lead to."));
  }
  merge_duplicates(from_mm, to_mm);
  const std::size_t points = from_mm.size();
  if (points > maximum_knots) {
    return failure("spline-too-many-points", GLISSON_TEXT("{0} points are too many for a spline; {1} is the most."),
                   {std::to_string(points), std::to_string(maximum_knots)});
  }
  const auto too_few = [] {
    return failure("spline-too-few-points",
                   GLISSON_TEXT("A spline needs four matched points that do not lie in one plane."));
  };
  if (points < 4) return too_few();

  // Positions from their centre, which keeps the system well conditioned.
  const auto n = static_cast<Eigen::Index>(points);
  Eigen::MatrixX4d plane(n, 4);
  Vector3d center = Vector3d::Zero();
  for (const Vector3d& point : from_mm) center += point / static_cast<double>(points);
  for (Eigen::Index i = 0; i < n; ++i) plane.row(i) << 1, (from_mm[static_cast<std::size_t>(i)] - center).transpose();
  Eigen::ColPivHouseholderQR<Eigen::MatrixX4d> rank(plane);
  rank.setThreshold(1e-7);
  if (rank.rank() < 4) return too_few();

  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      system(i, j) = system(j, i) =
          (from_mm[static_cast<std::size_t>(i)] - from_mm[static_cast<std::size_t>(j)]).norm();
    }
    system(i, i) = -stiffness_mm;  // the kernel r is negative definite on what affine maps leave over
    right.row(i) = to_mm[static_cast<std::size_t>(i)].transpose();
  }
  system.topRightCorner(n, 4) = plane;
  system.bottomLeftCorner(4, n) = plane.transpose();
  const Eigen::MatrixX3d solution = system.partialPivLu().solve(right);
  if (!solution.allFinite()) return too_few();

  ThinPlateSpline spline;
  spline.centers_mm_ = std::move(from_mm);
  spline.weights_ = solution.topRows(n).transpose();
  spline.affine_ = solution.bottomRows(4).transpose();
  spline.affine_.col(0) -= spline.affine_.rightCols<3>() * center;
  return spline;
}

Vector3d ThinPlateSpline::operator()(const Vector3d& point_mm) const {
  Vector3d result = affine_.col(0) + affine_.rightCols<3>() * point_mm;
  for (std::size_t i = 0; i < centers_mm_.size(); ++i) {
    result += weights_.col(static_cast<Eigen::Index>(i)) * (point_mm - centers_mm_[i]).norm();
  }
  return result;
}

Eigen::Matrix3d ThinPlateSpline::jacobian(const Vector3d& point_mm) const {
  Eigen::Matrix3d result = affine_.rightCols<3>();
  for (std::size_t i = 0; i < centers_mm_.size(); ++i) {
    const Vector3d from_center = point_mm - centers_mm_[i];
    const double distance_mm = from_center.norm();
    if (distance_mm > 0) {
      result += weights_.col(static_cast<Eigen::Index>(i)) * from_center.transpose() / distance_mm;
    }
  }
  return result;
}

}  // namespace glisson::registration
