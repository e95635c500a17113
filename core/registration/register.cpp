#include "registration/register.h"

namespace glisson::registration {
namespace {

using geometry::Surface;

Result<Registered> bend(const Surface& aligned, const Surface& target, int rigid_iterations,
                        const NonrigidIcpOptions& options, const Progress& progress) {
  auto bent = nonrigid_icp(aligned, target, options, progress);
  if (!bent) return failure(bent.error());
  if (bent->stopped == IcpStop::cancelled) return cancelled();
  Registered registered;
  registered.surface = std::move(bent->surface);
  registered.rms_mm = bent->rms_mm;
  registered.iterations = rigid_iterations + bent->iterations;
  return registered;
}

Result<Registered> register_by_icp(const Surface& source, const Surface& target, const RegisterOptions& options,
                                   const Progress& progress) {
  const auto rigid = rigid_icp(source, target, options.rigid, progress.part(0, 0.2));
  if (!rigid) return failure(rigid.error());
  if (rigid->stopped == IcpStop::cancelled) return cancelled();
  return bend(moved(source, rigid->transform), target, rigid->iterations, options.nonrigid, progress.part(0.2, 1));
}

}  // namespace

Result<Registered> register_surfaces(const Surface& source, const Surface& target, const RegisterOptions& options,
                                     const Progress& progress) {
  if (options.method == Method::icp) return register_by_icp(source, target, options, progress);
  const auto match = match_surfaces(source, target, options.geo, progress.part(0, 0.5));
  if (!match) return failure(match.error());
  return register_by_matches(source, target, *match, options.nonrigid, progress.part(0.5, 1));
}

Result<Registered> register_by_matches(const Surface& source, const Surface& target, const SurfaceMatch& match,
                                       const NonrigidIcpOptions& options, const Progress& progress) {
  constexpr double mirrored = 0.4;
  if (match.orientation_kept < mirrored) {
    return failure(Error{"registration-mirrored",
                         GLISSON_TEXT("By their geodesic distances the surfaces match only inside out."),
                         {},
                         GLISSON_TEXT("Align them roughly and match with positions as prior, or use more points."),
                         {}});
  }
  std::vector<Eigen::Vector3d> from_mm, to_mm;
  for (std::size_t i = 0; i < match.source_points.size(); ++i) {
    from_mm.push_back(source.points_mm[static_cast<std::size_t>(match.source_points[i])]);
    to_mm.push_back(target.points_mm[static_cast<std::size_t>(match.target_points[i])]);
  }
  const auto motion = align_points(from_mm, to_mm);
  if (!motion) return failure(motion.error());

  NonrigidIcpOptions bending = options;
  for (std::size_t i = 0; i < from_mm.size(); ++i) bending.landmarks.push_back({match.source_points[i], to_mm[i]});
  auto registered = bend(moved(source, *motion), target, 0, bending, progress);
  if (registered) registered->orientation_kept = match.orientation_kept;
  return registered;
}

}  // namespace glisson::registration
