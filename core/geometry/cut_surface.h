#pragma once
// A surface that divides space in two: a plane, a sheet through points that somebody drew, or a line swept inwards.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"

namespace glisson::geometry {

// A sheet is a height over its plane, height = a + b u + c v + sum of w_i r_i^2 log r_i, with r_i the distance in the
// plane from point i. That is the thin plate, which bends least among all that pass through the points (Duchon 1977;
// Wahba 1990, Spline Models for Observational Data, 2.4). A plane is a sheet without points.
//
// A swept line is what a knife parts that is drawn over a body, always held the same way: all places that lie along
// `into_mm` from those of the line. Its height is the distance across that way, above zero to the right of whoever
// walks along the line on the body; both ends go on straight. Longer by some places it is the same around those before,
// to the bit, but for where its end went on.
class CutSurface {
 public:
  // Failure: "cut-invalid" (a number that is not finite, a normal without a length).
  static Result<CutSurface> plane(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal);

  // Through the points exactly, over the plane that fits them best. Fails with "cut-invalid" where there are fewer than
  // three points, more than 2000, or one that is not finite. It does so where they lie almost on a line, which does not
  // say which way to cut. It does so where no height over their plane can pass through them, as when two lie almost
  // above each other.
  static Result<CutSurface> through(const std::vector<Eigen::Vector3d>& points_mm);

  // A line of 2 to 2000 places, and the way from it to where the cut ends. Fails with "cut-invalid" where a number is
  // not finite, the way has no length, or two places that follow each other are less than 1e-3 mm apart across it.
  static Result<CutSurface> swept(const std::vector<Eigen::Vector3d>& line_mm, const Eigen::Vector3d& into_mm);

  // How far above the surface (mm), along the plane's normal: for a plane the signed distance. Zero on the surface. Of
  // a swept line the distance across the way in.
  [[nodiscard]] double height_mm(const Eigen::Vector3d& position_mm) const;

  // Along two axes across the normal, from point_mm(); and the place of the surface over such a pair. Not of a swept
  // line.
  [[nodiscard]] Eigen::Vector2d across_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] Eigen::Vector3d on_surface_mm(const Eigen::Vector2d& across_mm) const;

  [[nodiscard]] const Eigen::Vector3d& point_mm() const { return point_mm_; }
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }
  [[nodiscard]] bool is_plane() const { return centers_mm_.cols() == 0; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& through_mm() const { return through_mm_; }  // none: a plane

  [[nodiscard]] bool is_swept() const { return into_mm_.squaredNorm() > 0; }
  [[nodiscard]] const Eigen::Vector3d& into_mm() const { return into_mm_; }  // zero where it is no swept line
  // Of a swept line, where a place lies by its nearest place of it: along it, both across the way in, and below it.
  struct OnLine {
    double along_mm, deep_mm;
  };
  [[nodiscard]] OnLine on_line(const Eigen::Vector3d& position_mm) const;

  // Planes to rounding, sheets through the same points, lines of the same places and way.
  [[nodiscard]] bool is_same(const CutSurface& other) const;
  // Whether this is the other swept line, or that one drawn further.
  [[nodiscard]] bool goes_on(const CutSurface& other) const;

 private:
  struct Foot {
    double along_mm, from_line_mm, below_mm;  // below_mm: how deep the line lies there
  };
  [[nodiscard]] Foot foot_of(const Eigen::Vector2d& across_mm) const;

  std::vector<Eigen::Vector3d> through_mm_;
  Eigen::Vector3d into_mm_{0, 0, 0};
  Eigen::VectorXd along_mm_, below_mm_;  // of a swept line's places
  Eigen::Vector3d point_mm_{0, 0, 0}, normal_{0, 0, 1};
  Eigen::Matrix<double, 2, 3> plane_;  // rows: two axes of the plane; of a swept line, across its way in
  Eigen::Matrix2Xd centers_mm_;
  Eigen::VectorXd weights_;
  Eigen::Vector3d affine_{0, 0, 0};  // a, b, c
};

}  // namespace glisson::geometry
