#pragma once
// What lies inside the organ, drawn where it is on a frame: outlines, since surgeons prefer them to filled shapes,
// which hide the tissue. Each place of an outline knows how far it may be from the truth.

#include <cstdint>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "geometry/surface.h"
#include "geometry/tetrahedra.h"
#include "guidance/elastic_registration.h"
#include "guidance/surface_lines.h"
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
  // Which of GuidanceCase::further_mm lie on it: from the first, so many. Their error is the outline's.
  std::size_t first_judged = 0, judged = 0;
  // In place of a surface of its own: lines on the organ's, such as a planned cut. Their error is the organ's there.
  std::vector<SurfaceLine> on_organ = {};
};

[[nodiscard]] EmbeddedStructure embedded(std::string name, const vision::Rgb& colour, geometry::Surface at_rest,
                                         const geometry::TetMesh& mesh);

// Points of the surface, each as far as can be from those before it; at most that many.
[[nodiscard]] std::vector<Eigen::Vector3d> spread_over(const geometry::Surface& surface, std::size_t count);

// Its points in the camera's frame, mm, under a placement that converged.
[[nodiscard]] std::vector<Eigen::Vector3d> placed_points_mm(const EmbeddedStructure& structure,
                                                            const geometry::TetMesh& mesh,
                                                            const ElasticPlacement& placement);

// A part of an outline, from pixel to pixel of the picture.
struct OutlinePiece {
  std::vector<Eigen::Vector2d> line_px;
  std::vector<double> sd_mm;  // one a point, of each coordinate of the error; infinite where nothing is known of it
};

struct PlacedOutline {
  std::size_t structure = 0;      // of the list
  double depth_mm = 0;            // from the camera, on average
  double sd_mm = 0;               // the largest over the structure; infinite where nothing is known of it
  std::optional<double> deep_mm;  // its nearest place behind the organ's front, along the line of sight
  std::vector<OutlinePiece> pieces;
};

// Around a surface that lies before the camera, with nothing known of its error.
[[nodiscard]] std::vector<OutlinePiece> outlines_of(const vision::Camera& camera, int width, int height,
                                                    const geometry::Surface& seen_mm);

// The outlines in a picture of that size, the deepest first, what lies on the organ's front last. The first structure
// is the organ itself. What `hidden` covers (one a pixel, not 0: an instrument; may be empty) and what only ends at the
// picture's edge is left out. Nothing under a placement that did not converge.
[[nodiscard]] std::vector<PlacedOutline> placed_outlines(const vision::Camera& camera, int width, int height,
                                                         const geometry::TetMesh& mesh,
                                                         const std::vector<EmbeddedStructure>& structures,
                                                         const ElasticPlacement& placement,
                                                         const std::vector<std::uint8_t>& hidden = {});

// Draws the outlines over the frame, each on a dark rim.
void draw_outlines(vision::Frame& frame, const std::vector<EmbeddedStructure>& structures,
                   const std::vector<PlacedOutline>& outlines);

}  // namespace glisson::guidance
