#pragma once
// The pose of an organ in the camera's frame without a first guess. It comes from curves that are recognised on both
// sides. Where there are none, it comes from the shape of what was seen.
//
// Triples of seen points are laid on triples of the same curves at rest that have the same distances from each other
// (random sampling: Fischler and Bolles 1981, Comm. ACM 24:381); the poses under which most of what was seen lies near
// the organ are refined by iterated closest points. Without curves, or with curves that lie near one straight line, the
// poses are turns spread evenly, with places of the side that faces the camera in the middle of the cloud. The best are
// refined by points to planes, and charged for cells of the picture where the organ would hide what was seen, or would
// be seen where nothing was. Deterministic.

#include <Eigen/Geometry>

#include "base/result.h"
#include "geometry/surface.h"
#include "guidance/frame.h"

namespace glisson::guidance {

// Scan to camera. `surface` is the organ's at rest, its triangles counter-clockwise from outside. Fails with
// "pose-not-found" where under no pose what was seen lies near the organ. Without five seen points on curves, or
// where these lie near one straight line, it fails also where poses in different places fit alike.
Result<Eigen::Isometry3d> find_pose(const geometry::Surface& surface, const SeenFrame& frame);

// What an organ that lies so leaves unexplained of a frame's cloud, mm: the mean distance of its points from the
// surface, at most 20 each, and as much for cells of the picture where it would hide what was seen, or half as much
// where it would be seen but nothing was. `surface` may be deformed, in the scan's frame.
[[nodiscard]] double unexplained_mm(const geometry::Surface& surface, const SeenFrame& frame,
                                    const Eigen::Isometry3d& pose);

}  // namespace glisson::guidance
