#pragma once
// A place of the surface that a rod of a tool presses on, and Coulomb's friction there: large_contact.h says how both
// join the body's energy. `u_mm` has 3 values a node; `k_mN_mm` is the springs' stiffness. Inside of this room.

#include <array>
#include <Eigen/Core>

#include "mechanics/contact/internal/contact_candidates.h"

namespace glisson::mechanics {

// A kept place with the rod where it is now, and the force that it is known to bear.
struct ContactConstraint {
  TrackedContact place;
  Rod rod;
  std::array<int, 3> nodes;
  Eigen::Vector3d rest_mm;
  double force_mN = 0;
  // Where there is friction: what the place is known to be dragged with, by how much at most, which way the tool faces
  // it, and where on the tool it came from, in the tool's frame and where that is now.
  double friction = 0;
  Eigen::Vector3d drag_mN{0, 0, 0};
  double maximum_drag_mN = 0;
  Eigen::Vector3d normal{0, 0, 1};
  Eigen::Vector3d from_on_tool_mm{0, 0, 0}, from_mm{0, 0, 0};
  bool slips = false;
};

// Where the place is now.
[[nodiscard]] Eigen::Vector3d place_of(const ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

// How far it is from its rod, which way that grows, and how that turns.
struct Gap {
  double mm;
  Eigen::Vector3d normal;
  Eigen::Matrix3d bend;
};
[[nodiscard]] Gap gap_of(const ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

// From now on the place drags with no more than mu times the force that it is known to bear, across the tool as it
// faces it now.
void limit_drag(ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

// The tangential force that it is dragged with, and how that turns and grows as the place moves on.
struct Drag {
  Eigen::Vector3d force_mN{0, 0, 0};
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  double energy_uJ = 0;
  bool slips = false;
};
[[nodiscard]] Drag drag_of(const ContactConstraint& constraint, double k_mN_mm, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
