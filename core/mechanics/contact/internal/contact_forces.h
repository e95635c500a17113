#pragma once
// The forces between bodies that touch without friction, as the solution of a small dense problem.

#include <Eigen/Core>

namespace glisson::mechanics {

// A mixed linear complementarity problem of m contacts and k pushed tools:
//   gaps = start + compliance forces - drives advances,   drives^T forces = drive_force
// - One-sided contacts: force >= 0, gap >= 0, and one of them is zero.
// - The last `two_sided` ones: gap = 0, and any force.
// - A column of `drives` (m x k) is a tool on a slide, pushed by a known force; its advance is where it comes to rest.
// The compliance is symmetric and positive semi-definite.
struct ContactProblem {
  Eigen::MatrixXd compliance;
  Eigen::VectorXd start;
  int two_sided = 0;
  Eigen::MatrixXd drives;
  Eigen::VectorXd drive_force;
};

struct ContactForces {
  Eigen::VectorXd force;
  Eigen::VectorXd advance;
  int exchanges = 0;
  bool converged = false;
};

// Block principal pivoting, with Murty's least-index exchange where it cycles (Judice and Pires 1994, Computers and
// Operations Research 21:587-596). The compliance's diagonal is raised by a thousandth, so that many contacts in one
// place have one answer; gaps are met to that. A pushed tool that no contact stops stays where it is, unconverged.
[[nodiscard]] ContactForces solve_contact(const ContactProblem& problem);

}  // namespace glisson::mechanics
