#pragma once
// Supports as values -> which unknowns are fixed, which faces stand on springs, which points hang on ligaments.

#include <cstdint>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

struct FoundationFace {
  std::size_t face;  // of the boundary
  double stiffness_kPa_per_mm;
};

// One spring of a ligament's fan.
struct LigamentSpring {
  int node;
  Eigen::Vector3d anchor_mm;
  double free_length_mm;  // up to which it does not pull
  double stiffness_mN_per_mm;
};

struct ResolvedSupports {
  std::vector<std::uint8_t> fixed;    // 3 a node (x, y, z): 1 where that displacement is fixed
  std::vector<int> support_of_fixed;  // one each of `fixed`: the first support that holds it, or -1
  Eigen::VectorXd prescribed_mm;      // 3 a node, zero where nothing is prescribed; empty where nothing is anywhere
  std::vector<FoundationFace> foundations;
  std::vector<LigamentSpring> ligaments;
};

// Fails with "support-empty": a support names no point, a foundation covers no face, or a ligament names no point of
// the surface. Fails with "array-unknown", or "support-invalid" (a number that is not finite or not positive). Fails
// with "support-contradicts" where two supports prescribe different displacements of one node.
Result<ResolvedSupports> resolve_supports(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                          const std::vector<BoundaryFace>& boundary,
                                          const std::vector<Support>& supports);

// What the supports leave free, as English ("can turn about the axis through (0.0, 0.0, 0.0) mm along x"). It is the
// null space of the supports on the six rigid motions. Nothing where the body can be in equilibrium. Ligaments, which
// only pull, do not count. The body must hang together.
std::string free_motion(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                        const ResolvedSupports& supports);

}  // namespace glisson::mechanics
