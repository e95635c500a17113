#pragma once
// What lies inside the organ, drawn where it is on a frame: outlines, since surgeons prefer them to filled shapes,
// which hide the tissue.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "guidance/elastic_registration.h"
#include "mechanics/elements/point_location.h"
#include "vision/calibration.h"
#include "vision/draw.h"

namespace glisson::guidance {

// A structure in the organ's mesh.
struct EmbeddedStructure {
  std::string name;
  vision::Rgb colour{255, 255, 255};
  geometry::Surface at_rest;                   // in the scan's frame, mm
  std::vector<mechanics::PointInMesh> places;  // one a point of the surface
};

[[nodiscard]] EmbeddedStructure embedded(std::string name, const vision::Rgb& colour, geometry::Surface at_rest,
                                         const geometry::TetMesh& mesh);

// Its points in the camera's frame, mm, under a placement that converged.
[[nodiscard]] std::vector<Eigen::Vector3d> placed_points_mm(const EmbeddedStructure& structure,
                                                            const geometry::TetMesh& mesh,
                                                            const ElasticPlacement& placement);

// Draws the outline of each, the deepest first. A placement that did not converge draws nothing.
void draw_placed(vision::Frame& frame, const vision::Camera& camera, const geometry::TetMesh& mesh,
                 const std::vector<EmbeddedStructure>& structures, const ElasticPlacement& placement);

}  // namespace glisson::guidance
