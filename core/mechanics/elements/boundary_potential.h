#pragma once
// What lies around a body and gives way as it moves: foundations, ligaments, the capsule, and the gas of a
// pneumoperitoneum. All of it has an energy, so that equilibrium is still the minimum of one. `u_mm` has 3 values a
// node; forces are in mN, 3 a node, energies in uJ; `pressure_kPa` is the gas's, on the whole boundary.
//
// Gas at constant pressure p around a closed body stores p V, V the body's volume (e.g. Bonet and Wood, 8.5). The
// integrals over faces are exact for linear and quadratic faces.

#include <Eigen/Core>

#include "mechanics/elements/block_assembly.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/internal_forces.h"

namespace glisson::mechanics {

[[nodiscard]] double boundary_energy_uJ(const Body& body, double pressure_kPa, const Eigen::VectorXd& u_mm);

// Minus the slope of the energy: what they push with.
[[nodiscard]] Eigen::VectorXd boundary_force_mN(const Body& body, double pressure_kPa, const Eigen::VectorXd& u_mm);

// Adds the slope of minus the force (mN/mm). All but the exact one leave out the gas and what of the capsule curves
// down.
void add_boundary_tangent(const Body& body, double pressure_kPa, const Eigen::VectorXd& u_mm, Tangent which,
                          const BlockSink& sink);

// What the ligaments alone pull with.
[[nodiscard]] Eigen::VectorXd ligament_force_mN(const Body& body, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
