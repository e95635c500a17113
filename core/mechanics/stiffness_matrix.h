#pragma once
// The stiffness of a whole body as one symmetric sparse matrix (mN/mm), its lower triangle stored by columns.

#include <Eigen/SparseCore>
#include <vector>

#include "geometry/tetrahedra.h"
#include "mechanics/boundary.h"
#include "mechanics/linear_elasticity.h"
#include "mechanics/node_layout.h"
#include "mechanics/supports.h"

namespace glisson::mechanics {

// 3 rows and columns a node, x y z. `materials` has one a cell. The result does not depend on the number of threads:
// each column is summed by one thread, in the order of the cells.
[[nodiscard]] Eigen::SparseMatrix<double> assemble_stiffness(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                                             const std::vector<Lame>& materials,
                                                             const std::vector<BoundaryFace>& boundary,
                                                             const std::vector<FoundationFace>& foundations);

}  // namespace glisson::mechanics
