#include "guidance/internal/seen_surface.h"

#include <algorithm>

namespace glisson::guidance {

using Eigen::Vector3d;

namespace {

geometry::Surface moved(const geometry::Surface& surface, const std::vector<int>& mesh_point_of,
                        const std::vector<Vector3d>& mesh_points_mm) {
  geometry::Surface there;
  there.triangles = surface.triangles;
  for (const int point : mesh_point_of) there.points_mm.push_back(mesh_points_mm[static_cast<std::size_t>(point)]);
  return there;
}

Vector3d weights_in(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& place) {
  const Vector3d ab = b - a, ac = c - a, ap = place - a;
  const double aa = ab.dot(ab), bb = ac.dot(ac), cross = ab.dot(ac);
  const double determinant = aa * bb - cross * cross;
  if (determinant <= 0) return {1, 0, 0};
  const double v = (bb * ap.dot(ab) - cross * ap.dot(ac)) / determinant;
  const double w = (aa * ap.dot(ac) - cross * ap.dot(ab)) / determinant;
  return {1 - v - w, v, w};
}

}  // namespace

SeenSurface::SeenSurface(const geometry::Surface& surface, const std::vector<int>& mesh_point_of,
                         const std::vector<Vector3d>& mesh_points_mm)
    : surface_(moved(surface, mesh_point_of, mesh_points_mm)),
      mesh_point_of_(mesh_point_of),
      normals_(geometry::point_normals(surface_)),
      distance_(surface_) {}

SeenSurface::Found SeenSurface::find(const Vector3d& position_mm) const {
  const auto closest = distance_.closest(position_mm);
  const auto& corners = surface_.triangles[static_cast<std::size_t>(closest.triangle)];
  const auto at = [&](int k) { return surface_.points_mm[static_cast<std::size_t>(corners[k])]; };
  const Vector3d weights = weights_in(at(0), at(1), at(2), closest.point_mm);
  Found found;
  found.row.direction.setZero();
  for (int k = 0; k < 3; ++k) {
    found.row.points[k] = mesh_point_of_[static_cast<std::size_t>(corners[k])];
    found.row.weights[k] = weights[k];
    found.row.direction += weights[k] * normals_[static_cast<std::size_t>(corners[k])];
  }
  found.row.points[3] = found.row.points[0];
  found.row.direction.normalize();
  found.row.at_mm = position_mm;
  const Vector3d off = position_mm - closest.point_mm;
  found.off_mm = off.dot(found.row.direction);
  found.beside_mm = (off - found.off_mm * found.row.direction).norm();
  return found;
}

double robust_weight(double off_mm, double noise_mm) {
  const double ratio = off_mm / noise_mm;
  return 5.0 / (4.0 + ratio * ratio);
}

}  // namespace glisson::guidance
