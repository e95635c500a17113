#pragma once
// A place of the surface that a rod of a tool presses on, and Coulomb's friction there: large_contact.h says how both
// join the body's energy. `u_mm` has 3 values a node.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "mechanics/contact/internal/contact_points.h"
#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// A place with the rod where it is now, and the multipliers: the forces found so far.
struct ContactConstraint {
  std::size_t tool = 0, which_rod = 0;
  ContactPoint at;
  Rod rod;
  std::array<int, 6> nodes;
  Eigen::Matrix<double, 6, 1> weights;
  Eigen::Vector3d rest_mm{0, 0, 0};
  double k_mN_mm = 0, along_mN_mm = 0;                         // of the penalty, along the normal and along the surface
  double multiplier_mN = 0;                                    // of the normal force
  double friction = 0;                                         // Coulomb's coefficient
  Eigen::Vector3d friction_mN{0, 0, 0};                        // the tangential multiplier
  double friction_limit_mN = 0;                                // where it slips
  Eigen::Vector3d normal{0, 0, 1};                             // out of the tool, when the limit was set
  Eigen::Vector3d from_on_tool_mm{0, 0, 0}, from_mm{0, 0, 0};  // where it slid from: on the tool, and where that is now
  bool slips = false;
};

// Its rod is the caller's.
[[nodiscard]] ContactConstraint constraint_at(const Body& body, std::size_t tool, std::size_t rod,
                                              const ContactPoint& at, double k_kPa_mm, double along_kPa_mm);

// So many times as stiff (mN/mm) as the surface itself is at a point, which answers with about E times an edge.
[[nodiscard]] double penalty_stiffness_mN_mm(double times, const Body& body, const geometry::Surface& surface);
// The same spread over the surface (kPa/mm): over what a point of it has about it.
[[nodiscard]] double penalty_stiffness_kPa_mm(double times, const Body& body, const geometry::Surface& surface);

// A penetration that nobody can see: where all forces are smaller than it makes, there is nothing left to solve.
inline constexpr double hair_mm = 1e-3;

// Where the place is now.
[[nodiscard]] Eigen::Vector3d place_of(const ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

// The distance from its rod, with its first and second derivative.
struct Gap {
  double mm;
  Eigen::Vector3d normal;
  Eigen::Matrix3d bend;
};
[[nodiscard]] Gap gap_of(const ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

// From now on it slides from where it is, on a tool of that pose.
void anchor(ContactConstraint& constraint, const Pose& tool, const Eigen::VectorXd& u_mm);

// Sets the limit of friction, mu times that normal force, and the tangential plane as the tool faces it now.
void limit_friction(ContactConstraint& constraint, double normal_mN, const Eigen::VectorXd& u_mm);

// The tangential force on it, minus its derivative by the place, and its energy.
struct FrictionForce {
  Eigen::Vector3d force_mN{0, 0, 0};
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  double energy_uJ = 0;
  bool slips = false;
};
[[nodiscard]] FrictionForce friction_force_of(const ContactConstraint& constraint, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
