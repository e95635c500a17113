#pragma once
// A flat cut through a body: a disc, or a whole plane.

#include <Eigen/Core>
#include <limits>

#include "base/result.h"
#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

struct PlaneCut {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};                             // unit length
  double radius_mm = std::numeric_limits<double>::infinity();  // infinite: the whole plane

  // Whether the disc stands between two places.
  [[nodiscard]] bool separates(const Eigen::Vector3d& a_mm, const Eigen::Vector3d& b_mm) const;
};

// The body with the cut opened (geometry/split_tetrahedra.h), along the plane itself: small tetrahedra are poor for
// finite elements and harmless to the meshfree engine, which only integrates over them. The points of the disc exist
// twice, once for each side. Failure: "cut-misses" (the disc does not cross the body), "cut-invalid".
Result<geometry::TetMesh> open_cut(const geometry::TetMesh& mesh, const PlaneCut& cut);

}  // namespace glisson::mechanics
