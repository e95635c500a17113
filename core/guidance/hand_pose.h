#pragma once
// An organ laid over a frame by hand: a pose (scan to camera) that is moved as a hand on the picture moves it. What is
// moved about is a place of the organ at rest, usually its middle. Pixels are the frame's.

#include <Eigen/Geometry>

#include "geometry/surface.h"
#include "guidance/elastic_registration.h"
#include "vision/calibration.h"

namespace glisson::guidance {

// Where to begin: seen from the front and a little from below, as through a port at the navel. The organ's middle lies
// in the middle of a picture of that size. It takes three quarters of the picture's width. The scan's axes are the
// patient's (LPS).
[[nodiscard]] Eigen::Isometry3d pose_before_camera(const vision::Camera& camera, int width, int height,
                                                   const geometry::Surface& organ);

// Moved across the line of sight, so that the place follows the hand by that many pixels.
[[nodiscard]] Eigen::Isometry3d shifted(const Eigen::Isometry3d& pose, const Eigen::Vector3d& about_mm,
                                        const vision::Camera& camera, const Eigen::Vector2d& by_px);

// Turned about the place as if the hand held its front. What goes to the right turns about the picture's upright axis,
// what goes down about its level one.
[[nodiscard]] Eigen::Isometry3d turned(const Eigen::Isometry3d& pose, const Eigen::Vector3d& about_mm, double right_deg,
                                       double down_deg);

// Turned in the picture's plane, clockwise as it is seen.
[[nodiscard]] Eigen::Isometry3d rolled(const Eigen::Isometry3d& pose, const Eigen::Vector3d& about_mm,
                                       double clockwise_deg);

// Moved along the line of sight through the place: its distance from the camera times `factor`, at least 20 mm.
[[nodiscard]] Eigen::Isometry3d moved_in_depth(const Eigen::Isometry3d& pose, const Eigen::Vector3d& about_mm,
                                               double factor);

// The organ as it is at rest under a pose; nothing is known of its error.
[[nodiscard]] ElasticPlacement rigid_placement(const Eigen::Isometry3d& pose, const geometry::TetMesh& mesh);

}  // namespace glisson::guidance
