#pragma once
// Energy, forces and stiffness of a body at large deformation: its material's functions of F, integrated over the
// cells (one point in a linear cell, four in a quadratic one). What is around it is not in here, except where said.
// `u_mm` has 3 values a node; forces are in mN, 3 a node.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/materials/material.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

// One material a cell, from the body's moduli. Neo-Hookean means the one that is stable under inversion;
// `strain_stiffening` is read by Veronda and Westmann's law.
[[nodiscard]] std::vector<Material> materials_of(const Body& body, MaterialLaw law, double strain_stiffening = 0);

// uJ; infinite where a material cannot be what the displacement makes of it.
[[nodiscard]] double strain_energy_uJ(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& u_mm);

// The slope of the energy: what the body resists with, to be balanced by the loads.
[[nodiscard]] Eigen::VectorXd internal_force_mN(const Body& body, const std::vector<Material>& materials,
                                                const Eigen::VectorXd& u_mm);

// `exact` is the slope of the force, and may not be positive definite; `positive` drops the negative curvature of
// each material point, which leaves a direction of descent (Teran et al. 2005, Robust Quasistatic Finite Elements).
// `warped` is the small-strain stiffness turned with each point, R C R^T, as in corotational.h: it leaves out what
// stress adds, which a step in time that is solved once would take for a brake on turning.
enum class Tangent { exact, positive, warped };

// Lower triangle (mN/mm), with what is around the body (boundary_potential.h): the gas at `pressure_kPa`.
[[nodiscard]] Eigen::SparseMatrix<double> tangent_stiffness(const Body& body, const std::vector<Material>& materials,
                                                            const Eigen::VectorXd& u_mm, Tangent which,
                                                            double pressure_kPa = 0);

// Von Mises' equivalent of Cauchy's stress P F^T / J (kPa) at each cell's centroid.
[[nodiscard]] std::vector<double> von_mises_of_cells(const Body& body, const std::vector<Material>& materials,
                                                     const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
