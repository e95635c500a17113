#pragma once
// A supported organ about a displacement at which parts of it have turned or stretched far. Forces f move it there as
// its tangent says, not as linear elasticity says of the organ at rest:
//
//   u(f) = u0 + K(u0)^-1 (f - r(u0))
//
// r is what the organ resists with, and K is its slope. K is the slope's positive part where the slope itself is not
// positive definite. This is a step of Newton's method: repeated, it ends in equilibrium.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "guidance/force_modes.h"
#include "mechanics/materials/material.h"
#include "mechanics/potentials/total_potential.h"
#include "mechanics/solvers/constrained_system.h"

namespace glisson::guidance {

class LargeDeformation {
 public:
  // `modes`, of a supported organ, must outlive it.
  LargeDeformation(const ForceModes& modes, mechanics::MaterialLaw law);
  LargeDeformation(const LargeDeformation&) = delete;  // what is within refers to itself
  LargeDeformation& operator=(const LargeDeformation&) = delete;

  // Turns to a displacement (mm, 3 a point; what is fixed stays there). Failures: those of the factorisation.
  Result<void> turn_to(const Eigen::VectorXd& u_mm);

  // After turn_to(): u under forces (mN, 3 a point), and what each column of further forces adds.
  [[nodiscard]] Eigen::VectorXd under(const Eigen::VectorXd& force_mN) const;
  [[nodiscard]] Eigen::MatrixXd moved_by(const Eigen::MatrixXd& forces_mN) const;
  // How far the forces are from equilibrium at that displacement, where nothing is fixed. It is a share of the size of
  // all of them, with those that hold what is fixed.
  [[nodiscard]] double off_equilibrium(const Eigen::VectorXd& force_mN) const;

 private:
  const ForceModes& modes_;
  std::vector<mechanics::Material> materials_;
  mechanics::TotalPotential energy_;
  std::optional<mechanics::ConstrainedSystem> system_;
  std::shared_ptr<const mechanics::EliminationOrder> order_;
  Eigen::VectorXd u_mm_;
  Eigen::VectorXd resisting_mN_;
};

}  // namespace glisson::guidance
