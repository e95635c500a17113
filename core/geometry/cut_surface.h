#pragma once
// A smooth surface that divides space in two: a plane, or a sheet through points that somebody drew.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"

namespace glisson::geometry {

// A sheet is a height over its plane, height = a + b u + c v + sum of w_i r_i^2 log r_i, with r_i the distance in the
// plane from point i. That is the thin plate, which bends least among all that pass through the points (Duchon 1977;
// Wahba 1990, Spline Models for Observational Data, 2.4). A plane is a sheet without points.
class CutSurface {
 public:
  // Failure: "cut-invalid" (a number that is not finite, a normal without a length).
  static Result<CutSurface> plane(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal);

  // Through the points exactly, over the plane that fits them best. Fails with "cut-invalid" where there are fewer than
  // three points, more than 2000, or one that is not finite. It does so where they lie almost on a line, which does not
  // say which way to cut. It does so where no height over their plane can pass through them, as when two lie almost
  // above each other.
  static Result<CutSurface> through(const std::vector<Eigen::Vector3d>& points_mm);

  // How far above the surface (mm), along the plane's normal: for a plane the signed distance. Zero on the surface.
  [[nodiscard]] double height_mm(const Eigen::Vector3d& position_mm) const;

  // Along two axes across the normal, from point_mm(); and the place of the surface over such a pair.
  [[nodiscard]] Eigen::Vector2d across_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] Eigen::Vector3d on_surface_mm(const Eigen::Vector2d& across_mm) const;

  [[nodiscard]] const Eigen::Vector3d& point_mm() const { return point_mm_; }
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }
  [[nodiscard]] bool is_plane() const { return centers_mm_.cols() == 0; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& through_mm() const { return through_mm_; }  // none: a plane

  // Planes to rounding, sheets through the same points.
  [[nodiscard]] bool is_same(const CutSurface& other) const;

 private:
  std::vector<Eigen::Vector3d> through_mm_;
  Eigen::Vector3d point_mm_{0, 0, 0}, normal_{0, 0, 1};
  Eigen::Matrix<double, 2, 3> plane_;  // rows: two axes of the plane
  Eigen::Matrix2Xd centers_mm_;
  Eigen::VectorXd weights_;
  Eigen::Vector3d affine_{0, 0, 0};  // a, b, c
};

}  // namespace glisson::geometry
