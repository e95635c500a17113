#pragma once
// A few points of a surface that carry its deformation (an embedded deformation graph; Sumner, Schmid, Pauly 2007):
// each point of the surface follows the control points of the cells around it.

#include <utility>
#include <vector>

#include "geometry/surface.h"

namespace glisson::registration {

struct ControlGraph {
  struct Share {
    int control = 0;
    double weight = 0;
  };
  std::vector<int> points;                 // of the surface, one a control
  std::vector<std::pair<int, int>> edges;  // controls whose cells touch, the smaller first
  std::vector<std::vector<Share>> shares;  // for each point of the surface; weights add to 1
};

// At most `most` controls, spread evenly; with enough of them every point is its own control, and edges are the
// surface's. Cells are found along the surface's edges, so that what is near through space alone stays apart.
ControlGraph control_graph(const geometry::Surface& surface, int maximum);

}  // namespace glisson::registration
