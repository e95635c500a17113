#pragma once
// The forces between bodies that touch without friction, as the solution of a small dense problem.

#include <Eigen/Core>

namespace glisson::mechanics {

// Given how the gaps of m contacts answer to their forces, gaps = start + compliance forces (symmetric, positive
// semi-definite), with the last `two_sided` of them held at zero from both sides: find forces such that at each of the
// others force >= 0, gap >= 0, and one of them is zero; and, for each column of `drives` (m x k), advances so that
//   gaps = start + compliance forces - drives advances,   drives^T forces = drive_force
// (a tool on a slide, pushed by a known force: the advance is where it comes to rest).
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

// A contact that bears gives by itself by a thousandth of what the body gives there, so that many contacts in one place
// have one answer; gaps are met to that. Block principal pivoting, which falls back to Murty's least-index exchange
// where it cycles (Judice and Pires 1994, Computers and Operations Research 21:587-596). A drive that no contact can
// take is left where it is, unconverged.
[[nodiscard]] ContactForces solve_contact(const ContactProblem& problem);

}  // namespace glisson::mechanics
