#include "anatomy/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glisson::anatomy {

using Eigen::Vector3d;

double Ellipsoid::distance_mm(const Vector3d& position_mm) const {
  const Vector3d scaled = (axes.transpose() * (position_mm - center_mm)).cwiseQuotient(semi_axes_mm);
  const double level = scaled.norm();
  if (level < 1e-9) return -semi_axes_mm.minCoeff();
  return level * (level - 1) / scaled.cwiseQuotient(semi_axes_mm).norm();
}

Ellipsoid ellipsoid(const Vector3d& center_mm, const Vector3d& semi_axes_mm, const Vector3d& turns_deg) {
  const Vector3d turns = turns_deg * std::numbers::pi / 180;
  return {center_mm, semi_axes_mm,
          (Eigen::AngleAxisd(turns.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(turns.y(), Vector3d::UnitY()) *
           Eigen::AngleAxisd(turns.x(), Vector3d::UnitX()))
              .toRotationMatrix()};
}

double Tube::distance_mm(const Vector3d& position_mm) const {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < points_mm.size(); ++i) {
    const OnStretch on = on_stretch(points_mm[i - 1], points_mm[i], position_mm);
    nearest = std::min(nearest, on.distance_mm - (radii_mm[i - 1] + on.along * (radii_mm[i] - radii_mm[i - 1])));
  }
  return nearest;
}

Tube smoothed(const Tube& tube, int pieces_each) {
  const int last = static_cast<int>(tube.points_mm.size()) - 1;
  const auto at = [&](int i) {
    const auto n = static_cast<std::size_t>(std::clamp(i, 0, last));
    return Eigen::Vector4d(tube.points_mm[n].x(), tube.points_mm[n].y(), tube.points_mm[n].z(), tube.radii_mm[n]);
  };
  Tube fine;
  for (int i = 0; i < last; ++i) {
    const Eigen::Vector4d a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    for (int step = i == 0 ? 0 : 1; step <= pieces_each; ++step) {
      const double t = static_cast<double>(step) / pieces_each;
      const Eigen::Vector4d p =
          0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);
      fine.points_mm.push_back(p.head<3>());
      fine.radii_mm.push_back(p[3]);
    }
  }
  return fine;
}

double Slab::distance_mm(const Vector3d& position_mm) const {
  const Vector3d from = position_mm - corner_mm;
  const double along = std::clamp(from.dot(along_mm) / along_mm.squaredNorm(), 0.0, 1.0);
  const double across = std::clamp(from.dot(across_mm) / across_mm.squaredNorm(), 0.0, 1.0);
  return (from - along * along_mm - across * across_mm).norm() - half_thickness_mm;
}

OnStretch on_stretch(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const Vector3d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return {(p - a - t * along).norm(), t};
}

double united(double a, double b, double width_mm) {
  const double h = std::max(width_mm - std::abs(a - b), 0.0) / width_mm;
  return std::min(a, b) - h * h * width_mm / 4;
}

double common(double a, double b, double width_mm) { return -united(-a, -b, width_mm); }

double without(double a, double taken_away, double width_mm) { return common(a, -taken_away, width_mm); }

}  // namespace glisson::anatomy
