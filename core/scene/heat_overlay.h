#pragma once
// SIRGn's heat mesh over a frame of the video, as the camera that took it would show it, lens and all.

#include <array>
#include <string>
#include <vector>

#include "geometry/surface.h"
#include "scene/colour.h"
#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::scene {

// How values become colours. Two algorithms are compared with one scale.
struct HeatScale {
  enum class Good { low, high };  // which end is good: it is light green; the bad end is dark blue
  std::array<double, 2> range{0, 1};
  Good good = Good::high;
  std::string title;  // of the legend, with the unit
  double opacity = 0.55;
};

// The scale that spans both lists of values but for the outermost fiftieth at each end.
HeatScale shared_scale(const std::vector<double>& a, const std::vector<double>& b, HeatScale::Good good,
                       std::string title);

Colour heat_colour(const HeatScale& scale, double value);

// What is drawn: triangles between points in the camera's space (mm). Rejected ones are grey, and ones that could not
// be judged are left out.
struct HeatMesh {
  enum class Verdict { accepted, rejected, none };
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> values;     // one a triangle
  std::vector<Verdict> verdicts;  // one a triangle
};

// A triangle as the camera shows it.
struct SeenTriangle {
  std::size_t triangle = 0;
  std::array<Eigen::Vector2d, 3> corners_px;
};

// The triangles of the mesh that are in front of the camera and could be judged, the farthest first.
std::vector<SeenTriangle> seen_triangles(const vision::Camera& camera, const HeatMesh& mesh);

// The frame with the mesh over it, the farthest triangles first, and a legend to its right, which makes it wider.
vision::Frame heat_overlay(const vision::Frame& frame, const vision::Camera& camera, const HeatMesh& mesh,
                           const HeatScale& scale);

}  // namespace glisson::scene
