#pragma once
// A tree of vessels as its centre line: nodes with a radius, each after its parent.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "anatomy/level_surface.h"

namespace glisson::anatomy {

enum class System { portal_vein, hepatic_vein, artery };
[[nodiscard]] const char* system_name(System system);  // "portal-vein", as the structure is called

struct VesselNode {
  Eigen::Vector3d position_mm{0, 0, 0};
  int parent = -1;       // -1: where the vessel enters; else less than this node's own index
  double radius_mm = 0;  // of the piece from the parent to here
  int segment = 0;       // Couinaud's, 1 to 8; 0 where the vessel serves more than one
  int generation = 0;    // divisions up to here, but where one child takes 70 % of the flow: it is the same vessel
  bool trunk = false;    // a named main branch, laid by the plan of the anatomy; else grown
  double flow = 0;       // terminal branches beyond, this one included
};

struct VesselTree {
  System system = System::portal_vein;
  std::vector<VesselNode> nodes;

  [[nodiscard]] std::vector<int> children_counts() const;
};

// From one division (or entry) to the next: the nodes of one unbranched stretch.
struct VesselBranch {
  std::vector<int> nodes;               // from the first after the division to the next division or the end
  double length_mm = 0, radius_mm = 0;  // the mean by length
  int segment = 0, generation = 0;
};
[[nodiscard]] std::vector<VesselBranch> branches_of(const VesselTree& tree);

// Radii follow Murray's law: r^3 of a parent is the sum of its children's (Murray 1926, PNAS 12:207). Every terminal
// branch carries the same flow, so r = root_radius (flow / whole flow)^(1/3). Sets flows, generations and radii.
void set_radii(VesselTree& tree, double root_radius_mm);

// Distance to the tree's wall on a grid, for pieces of at least the given radius; `far_mm` where none is near.
[[nodiscard]] Field tree_field(const VesselTree& tree, const imaging::Grid& grid, double minimum_radius_mm);

// The wall as a closed surface: what of the tree is at least that wide, on a grid of `spacing_mm`.
[[nodiscard]] geometry::Surface tree_surface(const VesselTree& tree, double minimum_radius_mm, double spacing_mm);

}  // namespace glisson::anatomy
