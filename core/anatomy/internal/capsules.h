#pragma once
// Distances between pieces of vessels, taken as capsules: a stretch with a radius.

#include <vector>

#include "anatomy/vessel_tree.h"

namespace glisson::anatomy {

struct Capsule {
  Eigen::Vector3d from_mm{0, 0, 0}, to_mm{0, 0, 0};
  double radius_mm = 0;
};

// Least distance between two stretches (Lumelsky 1985, Information Processing Letters 21:55).
[[nodiscard]] double distance_mm(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1, const Eigen::Vector3d& b0,
                                 const Eigen::Vector3d& b1);

[[nodiscard]] Capsule capsule_of(const VesselTree& tree, std::size_t node);

// Whether the capsule comes nearer than `clear_mm` to the tree, wall to wall.
[[nodiscard]] bool comes_near(const Capsule& capsule, const VesselTree& tree, double clear_mm);

// Pairs of pieces, one of each tree, whose walls are nearer than `clear_mm`.
struct Meeting {
  std::size_t first = 0, second = 0;
};
[[nodiscard]] std::vector<Meeting> meetings(const VesselTree& first, const VesselTree& second, double clear_mm);

// Along the tree from one node to another, and between different entries straight.
[[nodiscard]] double path_mm(const VesselTree& tree, int from, int to);

// Where two branches part, their walls touch. Of a piece that begins this far along the tree from another, this leaves
// what can be held against that other. As far as two branches at 30 degrees take to part; false if nothing is left.
bool trim_parting(Capsule& piece, double other_radius_mm, double path_mm);

// The same within one tree, but for pieces that share a node and but for where branches part.
[[nodiscard]] std::vector<Meeting> meetings_within(const VesselTree& tree, double clear_mm);

// The tree without the pieces named and all beyond them.
[[nodiscard]] VesselTree pruned(const VesselTree& tree, std::vector<bool> cut);

}  // namespace glisson::anatomy
