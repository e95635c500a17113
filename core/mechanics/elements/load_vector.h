#pragma once
// Loads as values -> forces on the nodes.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

// Forces (mN), 3 a node, of all the loads together. Failures: "tool-touches-nothing", "load-invalid" (which load, and
// what about it is not a finite number or out of range).
Result<Eigen::VectorXd> load_vector(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                    const std::vector<BoundaryFace>& boundary, double density_kg_mm3,
                                    const Loads& loads);

// A tool's force spread evenly over the faces of the boundary that it touches. Failure: "tool-touches-nothing".
struct SpreadForce {
  std::vector<std::size_t> faces;  // ascending
  Eigen::Vector3d traction_kPa;
};
Result<SpreadForce> spread(const ToolLoad& tool, const std::vector<BoundaryFace>& boundary);

// The loads on a body, apart: what stays as it is, and the pressure of the gas that follows the surface
// (follower_pressure.h).
struct AppliedLoads {
  Eigen::VectorXd dead_mN;
  double follower_pressure_kPa = 0;
};
enum class PressureKind { follower, dead };
Result<AppliedLoads> applied_loads(const Body& body, const Loads& loads, PressureKind kind);

}  // namespace glisson::mechanics
