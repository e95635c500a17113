#pragma once
// What a jump of the displacement across a cut adds to a body's equations. That is its coupling to the nodes, its own
// stiffness, and the work of standing loads on it.
//
// A point i of a crossed cell carries a jump a_i by the function L_i (H - H_i): L_i is the point's linear shape
// function. H is 1 above the surface and 0 below, and H_i its value at the point (Moes, Dolbow and Belytschko 1999,
// Int. J. Numer. Meth. Eng. 46:131; shifted: Zi and Belytschko 2003, ibid. 57:2221). The sum over points of L_i a_i is
// then the jump from below to above. A node's own displacement stays what it was without the cut.
//
// Gradients of quadratic cells are linear and those of L_i constant, so that the centroids of a cell's two parts
// integrate their products exactly.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/point_location.h"

namespace glisson::mechanics {

// Of jumps at `points`, 3 columns a point and 3 rows a node (mN/mm).
[[nodiscard]] Eigen::SparseMatrix<double> coupling(const Body& body, const Crossing& crossing,
                                                   const std::vector<int>& points);

// Between jumps at two lists of points, 3 rows and 3 columns a point (mN/mm).
[[nodiscard]] Eigen::MatrixXd stiffness_between(const Body& body, const Crossing& crossing,
                                                const std::vector<int>& rows, const std::vector<int>& columns);

// What of that is the foundations' (mN/mm along each axis): one row a node and one column a jump. `number` is the jump
// of each point of the mesh, -1 for none.
void add_foundation_springs(const Body& body, const Crossing& crossing, const std::vector<int>& number,
                            std::vector<Eigen::Triplet<double>>& with_nodes,
                            std::vector<Eigen::Triplet<double>>& between);

// What the loads push on the jumps with (mN, 3 a point). Gas presses on the walls too. The loads must have passed
// load_vector.
[[nodiscard]] Eigen::VectorXd load_on(const Body& body, const Crossing& crossing, const Loads& loads,
                                      const std::vector<int>& points);

// The value of a point's function at a place: 0 in cells that are not crossed or do not have the point.
[[nodiscard]] double value_at(const geometry::TetMesh& mesh, const Crossing& crossing, int point,
                              const PointInMesh& place);

// How much of a point's cells its function fills, between 0 and 1: where that is next to nothing, so is its stiffness.
[[nodiscard]] double share_filled(const geometry::TetMesh& mesh, const Crossing& crossing, int point,
                                  const std::vector<double>& volume_around_mm3);

}  // namespace glisson::mechanics
