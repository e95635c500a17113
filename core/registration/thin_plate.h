#pragma once
// Thin-plate splines in space: the smoothest warp through matched points, or near them.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"

namespace glisson::registration {

// f(p) = affine(p) + sum over i of w_i |p - p_i|, which minimises the bending energy of a warp of space. Source:
// Bookstein 1989; the kernel in three dimensions is the distance.
class ThinPlateSpline {
 public:
  // Leads from_mm[i] to to_mm[i]. `stiffness_mm` >= 0 trades closeness for smoothness (Wahba 1990): 0 interpolates, s
  // adds s to the kernel's diagonal. A lone displaced point is followed the less the larger s is compared with the
  // distance to its neighbours. Duplicated source points are merged to their mean. Failures: "spline-sizes" (of
  // different counts, or not finite); "spline-too-few-points" (fewer than four, or all in one plane);
  // "spline-too-many-points" (above 6000: the system is dense).
  static Result<ThinPlateSpline> fit(std::vector<Eigen::Vector3d> from_mm, std::vector<Eigen::Vector3d> to_mm,
                                     double stiffness_mm = 0);

  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& point_mm) const;

  // d f / d p; at a source point, where the kernel has a kink, that point's own part is left out.
  [[nodiscard]] Eigen::Matrix3d jacobian(const Eigen::Vector3d& point_mm) const;

 private:
  std::vector<Eigen::Vector3d> centers_mm_;
  Eigen::Matrix3Xd weights_;
  Eigen::Matrix<double, 3, 4> affine_;
};

}  // namespace glisson::registration
