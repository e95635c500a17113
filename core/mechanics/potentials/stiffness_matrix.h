#pragma once
// The stiffness of a whole body as one symmetric sparse matrix (mN/mm), its lower triangle stored by columns.

#include <Eigen/SparseCore>

#include "mechanics/elements/body.h"

namespace glisson::mechanics {

// 3 rows and columns a node, x y z; with the foundations and the capsule at rest. The result does not depend on the
// number of threads: each column is summed by one thread, in the order of the cells.
[[nodiscard]] Eigen::SparseMatrix<double> assemble_stiffness(const Body& body);

}  // namespace glisson::mechanics
