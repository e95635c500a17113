#pragma once
// Lines joined after they were found: where vessels touch, and over gaps of the mask.

#include <vector>

#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

struct NewJoint {
  int branch_a = 0, point_a = 0, branch_b = 0, point_b = 0;
  Joint joint = Joint::contact;
  double radius_mm = 0;
};

// Branches are divided at the points where joints stand; branches of two points are added between.
void join(VesselGraph& graph, const std::vector<NewJoint>& joints);

// Each piece is joined to others over gaps, the straightest and shortest first, never closing a loop. A gap is bridged
// where the line that ends there points at the other within 60 degrees. Then two ends of vessels as wide as each other
// that face each other within 30 degrees are joined too, whatever else joins their pieces.
void add_bridges(VesselGraph& graph, double maximum_gap_mm);

}  // namespace glisson::vasculature
