#pragma once
// A liver of a given volume: the shape at its size and place, its surface, and how deep each point lies in it.
//
// Frame: patient coordinates, LPS, mm; the body's axis stands at (0, -163), the portal vein divides near z = -285.

#include "anatomy/level_surface.h"
#include "anatomy/liver_shape.h"

namespace glisson::anatomy {

struct LiverBody {
  LiverShape shape;
  double scale = 1;  // of the shape's lengths
  geometry::Surface surface;
  Field distance_mm;  // outside the liver's surface, negative inside, every 3 mm or so

  [[nodiscard]] Eigen::Vector3d to_patient(const Eigen::Vector3d& shape_mm) const;
  [[nodiscard]] Eigen::Vector3d to_shape(const Eigen::Vector3d& patient_mm) const;
  // How deep under the surface; negative outside. Interpolated.
  [[nodiscard]] double depth_mm(const Eigen::Vector3d& patient_mm) const;
  [[nodiscard]] Tube to_patient(Tube shape_tube) const;
};

// The volume is that which the surface encloses, and is met to rounding. `spacing_mm` is the surface's grid.
[[nodiscard]] LiverBody make_liver_body(LiverShape shape, double volume_ml, double spacing_mm = 3);

}  // namespace glisson::anatomy
