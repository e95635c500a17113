#pragma once
// Equilibrium of a specimen that stiffens with strain (state.h, StiffeningLaw), for many loads at once, by Newton's
// method. Its steps are conjugate gradients on the exact tangent. The linear specimen's factor preconditions them;
// nothing is factorised anew. What an anisotropic structure adds to an isotropic one stays linear under the laws for
// large strain.

#include <Eigen/Core>
#include <vector>

#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// What the structure with this law resists a displacement with (mN), springs and membrane included.
[[nodiscard]] Eigen::VectorXd resisting_force_mN(const SpecimenBody& specimen, const Structure& structure,
                                                 const Stiffening& stiffening,
                                                 const Eigen::Ref<const Eigen::VectorXd>& u_mm);

// One equilibrium a column of forces (mN), from the displacements given. `linear` is the structure's solution without
// stiffening. They are in balance to `tolerance` of the load. Failure: "stiffening-diverged".
Result<Eigen::MatrixXd> stiffened_equilibria(const SpecimenBody& specimen, const PalpationSolver::Solution& linear,
                                             const Stiffening& stiffening, const Eigen::MatrixXd& forces_mN,
                                             const Eigen::MatrixXd& start_mm, double tolerance = 1e-6);

// (tangent at equilibrium `state_of_column[c]`)^-1 times column c of the forces. Failure: "stiffening-diverged".
Result<Eigen::MatrixXd> solve_tangent(const SpecimenBody& specimen, const PalpationSolver::Solution& linear,
                                      const Stiffening& stiffening, const Eigen::MatrixXd& equilibria_mm,
                                      const Eigen::MatrixXd& forces_mN,
                                      const std::vector<Eigen::Index>& state_of_column, double relative_tolerance);

}  // namespace glisson::closedloop
