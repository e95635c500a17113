#include "anatomy/liver_body.h"

#include <cmath>

#include "geometry/surface.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

namespace {

const Vector3d origin_in_patient_mm(0, -163, -285);

}  // namespace

Vector3d LiverBody::to_patient(const Vector3d& shape_mm) const { return origin_in_patient_mm + scale * shape_mm; }
Vector3d LiverBody::to_shape(const Vector3d& patient_mm) const { return (patient_mm - origin_in_patient_mm) / scale; }
double LiverBody::depth_mm(const Vector3d& patient_mm) const { return -interpolated(distance_mm, patient_mm); }

Tube LiverBody::to_patient(Tube tube) const {
  for (Vector3d& point : tube.points_mm) point = to_patient(point);
  for (double& radius : tube.radii_mm) radius *= scale;
  return tube;
}

// All in the shape's size first: lengths of a net scale with it, so that one net gives the factor exactly.
LiverBody make_liver_body(LiverShape shape, double volume_ml, double spacing_mm) {
  constexpr double usual_scale = 0.87;
  const Vector3d corner = Vector3d::Constant(shape.bound_mm());
  const Field field = sampled(grid_over({-corner, corner}, spacing_mm / usual_scale),
                              [&](const Vector3d& p) { return shape.distance_mm(p); });
  geometry::Surface surface = geometry::connected_pieces(level_surface(field)).front();
  const double scale = std::cbrt(1000 * volume_ml / geometry::volume_mm3(surface));
  LiverBody body{std::move(shape), scale, std::move(surface), field};
  for (Vector3d& point : body.surface.points_mm) point = body.to_patient(point);
  body.distance_mm.grid.origin_mm = body.to_patient(field.grid.origin_mm);
  body.distance_mm.grid.spacing_mm *= scale;
  for (float& value : body.distance_mm.values) value *= static_cast<float>(scale);
  return body;
}

}  // namespace glisson::anatomy
