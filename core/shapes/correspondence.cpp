#include "shapes/correspondence.h"

#include <fmt/format.h>

#include "anatomy/patient.h"
#include "geometry/nearest.h"
#include "registration/register.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

Surface shifted(Surface surface, const Vector3d& by_mm) {
  for (Vector3d& point : surface.points_mm) point += by_mm;
  return surface;
}

// As wide along each axis of the patient, about the middle of `target`.
Surface resized(Surface surface, const Surface& target) {
  const geometry::Box from = geometry::bounding_box(surface.points_mm), to = geometry::bounding_box(target.points_mm);
  const Vector3d scale = (to.max_mm - to.min_mm).cwiseQuotient(from.max_mm - from.min_mm);
  for (Vector3d& point : surface.points_mm) point = to.center_mm() + scale.cwiseProduct(point - from.center_mm());
  return surface;
}

Surface mirrored(Surface surface) {
  for (Vector3d& point : surface.points_mm) point.x() = -point.x();
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return surface;
}

Result<double> rigid_rms_mm(const Surface& reference, const Surface& liver) {
  registration::RigidIcpOptions options;
  options.overlap = registration::Overlap::neither;
  options.kept_fraction = 1;
  options.iterations = 25;
  options.smallest_step_mm = 0.05;
  return registration::rigid_icp(
             shifted(reference, geometry::mean_point_mm(liver) - geometry::mean_point_mm(reference)), liver, options)
      .map([](const registration::RigidIcpResult& found) { return found.rms_mm; });
}

}  // namespace

Result<Surface> reference_liver(double spacing_mm) { return anatomy::make_liver_surface({}, spacing_mm); }

Result<Corresponding> correspond(const Surface& reference, const Surface& liver, const Surface& coarse,
                                 const Progress& progress) {
  const auto as_it_is = rigid_rms_mm(reference, coarse);
  if (!as_it_is) return failure(as_it_is.error());
  const auto as_mirrored = rigid_rms_mm(reference, mirrored(coarse));
  if (!as_mirrored) return failure(as_mirrored.error());
  Corresponding found;
  found.mirrored_ratio = *as_mirrored / *as_it_is;
  if (found.mirrored_ratio < 1) {
    return failure(Error{"shapes-mirrored",
                         GLISSON_TEXT("The liver's mirror image is more like a liver ({0} mm from a typical one, "
                                      "against {1} mm): left and right are exchanged, or the patient is a rare one."),
                         {fmt::format("{:.1f}", *as_mirrored), fmt::format("{:.1f}", *as_it_is)},
                         GLISSON_TEXT("Look at the file's affine: which way its first axis runs."),
                         {}});
  }
  registration::RegisterOptions options;
  options.method = registration::Method::geo;
  options.geo.prior = registration::Prior::positions;
  options.nonrigid.overlap = registration::Overlap::neither;
  options.nonrigid.maximum_controls = 600;
  options.nonrigid.iterations_each = 5;
  options.nonrigid.smallest_step_mm = 0.05;
  options.nonrigid.stiffness = {50, 15, 5, 2, 0.8, 0.3};
  auto registered = registration::register_surfaces(resized(reference, liver), coarse, options, progress.part(0, 0.7));
  if (!registered) return failure(registered.error());
  registration::NonrigidIcpOptions finishing = options.nonrigid;
  finishing.maximum_controls = 900;
  finishing.stiffness = {0.6, 0.25, 0.1};
  finishing.iterations_each = 3;
  auto finished = registration::nonrigid_icp(registered->surface, liver, finishing, progress.part(0.7, 1));
  if (!finished) return failure(finished.error());
  found.surface = std::move(finished->surface);
  found.orientation_kept = registered->orientation_kept;
  found.mean_mm = geometry::gap_between(found.surface, liver, 4).mean_mm;
  constexpr double farthest_mm = 4;
  if (found.mean_mm > farthest_mm) {
    return failure(
        Error{"shapes-outside",
              GLISSON_TEXT("A typical liver cannot be bent onto this one: {0} mm are left on average."),
              {fmt::format("{:.1f}", found.mean_mm)},
              GLISSON_TEXT("Look whether the labels are one whole liver, neither resected nor transplanted."),
              {}});
  }
  return found;
}

}  // namespace glisson::shapes
