#pragma once
// The consistent mass of a body of quadratic tetrahedra with straight edges.

#include <Eigen/SparseCore>

#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// Lower triangle (kg), 3 rows and columns a node: the integral of density N_i N_j, exact. The entries sum to three
// times the body's mass.
[[nodiscard]] Eigen::SparseMatrix<double> consistent_mass_kg(const Body& body);

}  // namespace glisson::mechanics
