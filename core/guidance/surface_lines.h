#pragma once
// Lines on the organ's surface: where a planned cut meets it, and where its segments border on each other. They lie on
// the edges of the surface's triangles, so that they go wherever the surface goes.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/surface.h"

namespace glisson::guidance {

// A place on an edge between two points of the surface, the `share` of the way from `a` to `b`.
struct EdgePlace {
  int a = 0, b = 0;  // a < b
  double share = 0.5;
};

// From edge to edge of one triangle after another; where it comes back to its beginning it ends there.
struct SurfaceLine {
  std::vector<EdgePlace> places;
  std::vector<int> triangles;  // between a place and the next: one fewer
};

// Where values, one a point of the surface, are zero: a height over a cut.
[[nodiscard]] std::vector<SurfaceLine> zero_lines(const geometry::Surface& organ, const std::vector<double>& values);

// Half-way between points of different labels, one a point; 0 is none and has no border.
[[nodiscard]] std::vector<SurfaceLine> border_lines(const geometry::Surface& organ, const std::vector<int>& labels);

// Where the line's places are, with the surface's points where they are now.
[[nodiscard]] std::vector<Eigen::Vector3d> places_of(const SurfaceLine& line,
                                                     const std::vector<Eigen::Vector3d>& now_mm);

}  // namespace glisson::guidance
