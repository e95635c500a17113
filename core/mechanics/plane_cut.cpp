#include "mechanics/plane_cut.h"

#include "geometry/split_tetrahedra.h"

namespace glisson::mechanics {

bool PlaneCut::separates(const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm) const {
  const double a = normal.dot(a_mm - center_mm), b = normal.dot(b_mm - center_mm);
  if ((a < 0) == (b < 0)) return false;
  const Eigen::Vector3d crossing_mm = a_mm + a / (a - b) * (b_mm - a_mm);
  return (crossing_mm - center_mm).norm() <= radius_mm;
}

Result<geometry::TetMesh> open_cut(const geometry::TetMesh& mesh, const PlaneCut& cut) {
  const auto plane = geometry::CutSurface::plane(cut.center_mm, cut.normal);
  if (!plane) return failure(plane.error());
  const auto in_disc = [&](const Eigen::Vector3d& place_mm) {
    return (place_mm - cut.center_mm).norm() <= cut.radius_mm;
  };
  geometry::SplitMesh split = geometry::split_tetrahedra(mesh, *plane, {.snap = 1e-3, .is_open = in_disc});
  if (split.doubled.empty()) {
    return failure(Error{"cut-misses",
                         GLISSON_TEXT("The cut does not cross the body."),
                         {},
                         GLISSON_TEXT("Check that cut and mesh are in the same coordinates (LPS, mm)."),
                         {}});
  }
  return std::move(split.mesh);
}

}  // namespace glisson::mechanics
