#pragma once
// The pose of an organ in the camera's frame from curves that are recognised on both sides, without a first guess.
//
// Triples of seen points are laid on triples of the same curves at rest that have the same distances from each other
// (random sampling: Fischler and Bolles 1981, Comm. ACM 24:381); the poses under which most of what was seen lies near
// the organ are refined by iterated closest points. Deterministic.

#include <Eigen/Geometry>

#include "base/result.h"
#include "geometry/surface.h"
#include "guidance/frame.h"

namespace glisson::guidance {

// Scan to camera. `surface` is the organ's at rest. Failure: "pose-not-found" (fewer than five seen points on curves,
// or no pose under which what was seen lies near the organ).
Result<Eigen::Isometry3d> find_pose(const geometry::Surface& surface, const SeenFrame& frame);

}  // namespace glisson::guidance
