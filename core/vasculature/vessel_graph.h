#pragma once
// Centre lines of vessels with their radii, as a graph: vertices where lines meet or end, branches between them.
//
// Frame: patient coordinates, LPS, mm. A graph may hold loops, where vessels touch; classify_vessels (systems.h) opens
// them.

#include <Eigen/Core>
#include <vector>

namespace glisson::vasculature {

struct CenterPoint {
  Eigen::Vector3d position_mm{0, 0, 0};
  double radius_mm = 0;
};

// What a branch stands on.
enum class Joint {
  vessel,  // a vessel of the mask
  gap,     // bridged: the mask is interrupted here
  contact  // two lines whose vessels touch sideways or end to end
};

// One unbranched stretch.
struct GraphBranch {
  int from = -1, to = -1;           // vertices; the same where it ends in itself
  std::vector<CenterPoint> points;  // from `from` to `to`, about one a millimetre, both ends included
  Joint joint = Joint::vessel;
  double length_mm = 0, radius_mm = 0;  // radius: the median along it
};

struct VesselGraph {
  std::vector<Eigen::Vector3d> vertices_mm;
  std::vector<GraphBranch> branches;

  // The branches that meet at each vertex.
  [[nodiscard]] std::vector<std::vector<int>> branches_at_vertices() const;
};

// How far a place is from the wall of the vessel along a line, mm; negative inside of it.
[[nodiscard]] double from_wall_mm(const std::vector<CenterPoint>& line, const Eigen::Vector3d& place_mm);

// Sets length and radius from the points.
void measure(GraphBranch& branch);

}  // namespace glisson::vasculature
