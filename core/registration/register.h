#pragma once
// One surface moved onto another, point for point: rigidly first, then as it bends.

#include "base/progress.h"
#include "geometry/surface.h"
#include "registration/geo.h"
#include "registration/nonrigid_icp.h"

namespace glisson::registration {

enum class Method {
  icp,  // rigid ICP, then non-rigid ICP (Amberg et al. 2007): from where the surfaces lie
  geo   // correspondence by geodesic distances (Chen and Koltun 2015); its matches lead the non-rigid step
};

struct RegisterOptions {
  Method method = Method::icp;
  RigidIcpOptions rigid;
  NonrigidIcpOptions nonrigid;
  GeoOptions geo;
};

struct Registered {
  geometry::Surface surface;    // the source moved, its points in their order
  double rms_mm = 0;            // of the pairs of nearest points, at the end
  int iterations = 0;           // rigid and non-rigid together
  double orientation_kept = 1;  // of the matching, for Method::geo: below 0.6 it should not be trusted
};

// For Method::geo without a prior, the matches also give the rigid motion, so that the surfaces may lie anywhere.
// Failures: those of rigid_icp, nonrigid_icp and match_surfaces; "registration-mirrored" where the matching turns the
// surface inside out, so that nothing good can come of it.
Result<Registered> register_surfaces(const geometry::Surface& source, const geometry::Surface& target,
                                     const RegisterOptions& options = {}, const Progress& progress = {});

// By matches that were found before, as FrameMatcher finds them. Failures: those of nonrigid_icp;
// "registration-mirrored".
Result<Registered> register_by_matches(const geometry::Surface& source, const geometry::Surface& target,
                                       const SurfaceMatch& match, const NonrigidIcpOptions& options = {},
                                       const Progress& progress = {});

}  // namespace glisson::registration
