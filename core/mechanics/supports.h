#pragma once
// Supports as values -> which unknowns are held and which faces stand on springs.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/boundary.h"
#include "mechanics/node_layout.h"
#include "mechanics/scenario.h"

namespace glisson::mechanics {

struct FoundationFace {
  std::size_t face;  // of the boundary
  double stiffness_kPa_per_mm;
};

struct ResolvedSupports {
  std::vector<std::uint8_t> held;  // 3 a node (x, y, z): 1 where that displacement is held
  std::vector<FoundationFace> foundations;
};

// Failures: "support-empty" (a support that names no point, or a foundation that covers no face), "array-unknown",
// "support-invalid" (a number that is not finite or not positive).
Result<ResolvedSupports> resolve_supports(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                          const std::vector<BoundaryFace>& boundary,
                                          const std::vector<Support>& supports);

// What the supports leave free, as English ("can turn about the axis through (0.0, 0.0, 0.0) mm along x"), or
// nothing where the body can be in equilibrium: the null space of the supports on the six rigid motions. The body
// must hang together.
std::string free_motion(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                        const ResolvedSupports& supports);

}  // namespace glisson::mechanics
