#pragma once
// The pose of an organ from one picture, by lines that are recognised on it and by its silhouette: no depth was seen.
// Lines of the model are laid over lines of the picture (2D to 3D), by least squares with Geman and McClure's weights
// whose width shrinks (graduated non-convexity: Blake and Zisserman 1987), from turns spread evenly. Of a line that is
// seen, what would lie on a side turned away is charged for; a laparoscope looks in through the belly, so that turns
// that look forwards and downwards are left out (the scan's axes are LPS). The organ stays as it is at rest: a picture
// alone does not tell a deformation from another pose. Deterministic.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "vision/calibration.h"

namespace glisson::guidance {

// What is seen of a line, in pixels as the camera took them, with its lens's distortion. The silhouette has nothing at
// rest: it is where the organ's surface turns away.
struct SeenContour {
  std::string id;
  std::vector<Eigen::Vector3d> at_rest_mm;
  std::vector<Eigen::Vector2d> seen_px;
  [[nodiscard]] bool is_silhouette() const { return at_rest_mm.empty(); }
};

// Mean distance of what was seen of a contour from where a pose puts it; in mm at the distance at which it puts it.
struct ContourError {
  double px = 0, mm = 0;
};

struct ContourPose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // scan to camera
  std::vector<std::optional<ContourError>> off;            // one a contour; none where the lens tells no direction
};

// `organ`: at rest, triangles counter-clockwise from outside. `guess`: where the search begins in place of all turns.
// Failures: "pose-not-found": fewer than two contours with places at rest and no guess; under no pose do they lie near
// each other; without a guess also where poses in different places fit alike.
Result<ContourPose> pose_of_contours(const geometry::Surface& organ, const vision::Camera& camera,
                                     const std::vector<SeenContour>& contours,
                                     const std::optional<Eigen::Isometry3d>& guess = {});

// The same of a contour that was left out.
[[nodiscard]] std::optional<ContourError> error_of(const SeenContour& contour, const geometry::Surface& organ,
                                                   const vision::Camera& camera, const Eigen::Isometry3d& pose);

}  // namespace glisson::guidance
