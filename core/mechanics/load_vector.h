#pragma once
// Loads as values -> forces on the nodes.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "mechanics/boundary.h"
#include "mechanics/node_layout.h"
#include "mechanics/scenario.h"

namespace glisson::mechanics {

// Forces (mN), 3 a node, of all the loads together. Failures: "tool-touches-nothing", "load-invalid" (which load, and
// what about it is not a finite number or out of range).
Result<Eigen::VectorXd> load_vector(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                    const std::vector<BoundaryFace>& boundary, double density_kg_mm3,
                                    const Loads& loads);

}  // namespace glisson::mechanics
