#include "geometry/cut_surface.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

namespace glisson::geometry {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Failure invalid(const std::string& why, std::vector<std::string> arguments = {}) {
  return failure(Error{"cut-invalid", why, std::move(arguments), {}, {}});
}

Eigen::Matrix<double, 2, 3> axes_across(const Vector3d& normal) {
  const Vector3d first = normal.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> axes;
  axes << first.transpose(), normal.cross(first).transpose();
  return axes;
}

double thin_plate(double squared_mm2) { return squared_mm2 > 0 ? 0.5 * squared_mm2 * std::log(squared_mm2) : 0.0; }

}  // namespace

Result<CutSurface> CutSurface::plane(const Vector3d& point_mm, const Vector3d& normal) {
  if (!point_mm.allFinite() || !normal.allFinite() || !(normal.norm() > 0)) {
    return invalid(GLISSON_TEXT("A cutting plane needs a finite point and a normal that is not zero."));
  }
  CutSurface surface;
  surface.point_mm_ = point_mm;
  // Of unit length to rounding it stays to the bit: what was written of a plane reads back as that plane.
  constexpr double rounding = 1e-14;
  surface.normal_ = std::abs(normal.squaredNorm() - 1.0) < rounding ? normal : normal.normalized();
  surface.plane_ = axes_across(surface.normal_);
  return surface;
}

Result<CutSurface> CutSurface::through(const std::vector<Vector3d>& points_mm) {
  constexpr std::size_t maximum_points = 2000;  // the system is dense
  if (points_mm.size() < 3 || points_mm.size() > maximum_points) {
    return invalid(GLISSON_TEXT("A cutting sheet needs 3 to {0} points; there are {1}."),
                   {std::to_string(maximum_points), std::to_string(points_mm.size())});
  }
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points_mm) {
    if (!point.allFinite()) return invalid(GLISSON_TEXT("A point of the cutting sheet is not finite."));
    mean += point / static_cast<double>(points_mm.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points_mm) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(spread);
  // A tenth in length: what is narrower does not say which way the sheet goes.
  if (!(modes.eigenvalues()[1] > 0.01 * modes.eigenvalues()[2])) {
    return invalid(
        GLISSON_TEXT("The points of the cutting sheet lie almost on a line, which does not say which way to "
                     "cut: add points away from it, or give a plane."));
  }
  CutSurface surface;
  surface.point_mm_ = mean;
  surface.normal_ = modes.eigenvectors().col(0).normalized();
  surface.plane_ = axes_across(surface.normal_);
  if (points_mm.size() == 3) return surface;  // they lie in their plane
  surface.through_mm_ = points_mm;

  const auto count = static_cast<Eigen::Index>(points_mm.size());
  surface.centers_mm_.resize(2, count);
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(count + 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector3d arm = points_mm[static_cast<std::size_t>(i)] - mean;
    surface.centers_mm_.col(i) = surface.plane_ * arm;
    heights[i] = arm.dot(surface.normal_);
  }
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 3, count + 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      const double squared_mm2 = (surface.centers_mm_.col(i) - surface.centers_mm_.col(k)).squaredNorm();
      const double rise_mm = heights[i] - heights[k];
      if (squared_mm2 < 0.01 * rise_mm * rise_mm || squared_mm2 < 1e-12) {  // steeper than 84 degrees, or the same
        return invalid(
            GLISSON_TEXT("Points {0} and {1} of the cutting sheet lie above each other: no smooth sheet over "
                         "their plane passes through both."),
            {std::to_string(k + 1), std::to_string(i + 1)});
      }
      system(i, k) = system(k, i) = thin_plate(squared_mm2);
    }
    system.block<1, 3>(i, count) << 1.0, surface.centers_mm_.col(i).transpose();
    system.block<3, 1>(count, i) = system.block<1, 3>(i, count).transpose();
  }
  const Eigen::VectorXd solved = system.partialPivLu().solve(heights);
  if (!solved.allFinite() || (system * solved - heights).norm() > 1e-6 * (1.0 + heights.norm())) {
    return invalid(GLISSON_TEXT("No smooth sheet passes through the points of the cut."));
  }
  surface.weights_ = solved.head(count);
  surface.affine_ = solved.tail<3>();
  return surface;
}

Result<CutSurface> CutSurface::swept(const std::vector<Vector3d>& line_mm, const Vector3d& into_mm) {
  constexpr std::size_t maximum_places = 2000;
  constexpr double shortest_mm = 1e-3;
  if (line_mm.size() < 2 || line_mm.size() > maximum_places) {
    return invalid(GLISSON_TEXT("A line that cuts needs 2 to {0} places; there are {1}."),
                   {std::to_string(maximum_places), std::to_string(line_mm.size())});
  }
  if (!into_mm.allFinite() || !(into_mm.norm() > 0)) {
    return invalid(GLISSON_TEXT("A line that cuts needs a way into the body with a length."));
  }
  CutSurface surface;
  surface.through_mm_ = line_mm;
  surface.into_mm_ = into_mm;
  surface.point_mm_ = line_mm.front();
  const Vector3d in = into_mm.normalized();
  surface.plane_ = axes_across(in);
  const auto count = static_cast<Eigen::Index>(line_mm.size());
  surface.centers_mm_.resize(2, count);
  surface.along_mm_ = surface.below_mm_ = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector3d& place_mm = line_mm[static_cast<std::size_t>(i)];
    if (!place_mm.allFinite()) return invalid(GLISSON_TEXT("A place of the line that cuts is not finite."));
    surface.centers_mm_.col(i) = surface.across_mm(place_mm);
    surface.below_mm_[i] = (place_mm - surface.point_mm_).dot(in);
    if (i == 0) continue;
    const double step_mm = (surface.centers_mm_.col(i) - surface.centers_mm_.col(i - 1)).norm();
    if (step_mm < shortest_mm) {
      return invalid(GLISSON_TEXT("Places {0} and {1} of the line that cuts lie above each other, along its way into "
                                  "the body."),
                     {std::to_string(i), std::to_string(i + 1)});
    }
    surface.along_mm_[i] = surface.along_mm_[i - 1] + step_mm;
  }
  const Vector2d first_mm = surface.centers_mm_.col(1) - surface.centers_mm_.col(0);
  surface.normal_ = in.cross(Vector3d(surface.plane_.transpose() * first_mm)).normalized();
  return surface;
}

Vector2d CutSurface::across_mm(const Vector3d& position_mm) const { return plane_ * (position_mm - point_mm_); }

Vector3d CutSurface::on_surface_mm(const Vector2d& across_mm) const {
  const Vector3d in_plane_mm = point_mm_ + plane_.transpose() * across_mm;
  return in_plane_mm - height_mm(in_plane_mm) * normal_;
}

bool CutSurface::is_same(const CutSurface& other) const {
  if (!is_plane() || !other.is_plane()) return through_mm_ == other.through_mm_ && into_mm_ == other.into_mm_;
  return normal_.isApprox(other.normal_, 1e-9) && std::abs(height_mm(other.point_mm_)) < 1e-6;
}

bool CutSurface::goes_on(const CutSurface& other) const {
  return is_swept() && into_mm_ == other.into_mm_ && through_mm_.size() >= other.through_mm_.size() &&
         std::equal(other.through_mm_.begin(), other.through_mm_.end(), through_mm_.begin());
}

// Of the nearest piece. Where that is a corner, the side is that of both pieces' mean way.
CutSurface::Foot CutSurface::foot_of(const Vector2d& across_mm) const {
  const Eigen::Index last = centers_mm_.cols() - 2;
  const auto way = [&](Eigen::Index piece) -> Vector2d {
    return (centers_mm_.col(piece + 1) - centers_mm_.col(piece)) / (along_mm_[piece + 1] - along_mm_[piece]);
  };
  double nearest_mm2 = std::numeric_limits<double>::infinity();
  Foot foot{};
  for (Eigen::Index piece = 0; piece <= last; ++piece) {
    const double length_mm = along_mm_[piece + 1] - along_mm_[piece];
    const Vector2d arm_mm = across_mm - centers_mm_.col(piece);
    const Vector2d ahead = way(piece);
    double at_mm = arm_mm.dot(ahead);
    Vector2d side = ahead;
    if (at_mm < 0 && piece > 0) {
      at_mm = 0;
      side += way(piece - 1);
    } else if (at_mm > length_mm && piece < last) {
      at_mm = length_mm;
      side += way(piece + 1);
    }
    const Vector2d off_mm = arm_mm - at_mm * ahead;
    if (!(off_mm.squaredNorm() < nearest_mm2)) continue;
    nearest_mm2 = off_mm.squaredNorm();
    const double left = side.x() * off_mm.y() - side.y() * off_mm.x();
    const double share = std::clamp(at_mm / length_mm, 0.0, 1.0);
    foot = {along_mm_[piece] + at_mm, left < 0 ? -off_mm.norm() : off_mm.norm(),
            below_mm_[piece] + share * (below_mm_[piece + 1] - below_mm_[piece])};
  }
  return foot;
}

CutSurface::OnLine CutSurface::on_line(const Vector3d& position_mm) const {
  const Foot foot = foot_of(across_mm(position_mm));
  return {foot.along_mm, (position_mm - point_mm_).dot(into_mm_) / into_mm_.norm() - foot.below_mm};
}

double CutSurface::height_mm(const Vector3d& position_mm) const {
  if (is_swept()) return foot_of(across_mm(position_mm)).from_line_mm;
  const Vector3d arm = position_mm - point_mm_;
  double sheet_mm = 0;
  if (!is_plane()) {
    const Vector2d at = plane_ * arm;
    sheet_mm = affine_[0] + affine_[1] * at.x() + affine_[2] * at.y();
    for (Eigen::Index i = 0; i < centers_mm_.cols(); ++i) {
      sheet_mm += weights_[i] * thin_plate((at - centers_mm_.col(i)).squaredNorm());
    }
  }
  return arm.dot(normal_) - sheet_mm;
}

}  // namespace glisson::geometry
