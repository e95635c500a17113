#pragma once
// A body ready to be computed: checked, its nodes laid out, its supports resolved. Every engine starts from one.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/elements/static_options.h"
#include "mechanics/elements/supports.h"
#include "mechanics/materials/linear_elasticity.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

struct Body {
  geometry::TetMesh mesh;
  std::vector<double> youngs_kPa;  // one a cell
  std::vector<Support> supports;
  StaticOptions options;
  NodeLayout layout;
  std::vector<BoundaryFace> boundary;
  ResolvedSupports resolved;
  std::vector<Lame> materials;  // one a cell
};

// Must the supports take all six rigid motions? For equilibrium they must; a moving body may fly.
enum class Holding { required, optional };

// Failures: those of check_tetrahedra and of resolve_supports; "too-large", "poisson-invalid", "density-invalid". Fails
// with "modulus-invalid" (the first cell is named), or "not-available" (a prescribed displacement where the options
// know none). Fails with "body-free" where holding is required (the free motion is named).
Result<Body> prepare_body(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                          const StaticOptions& options, Holding holding);

// What the foundations push with (mN, 3 a node) where the nodes have moved by u (mm, 3 a node).
[[nodiscard]] Eigen::VectorXd foundation_force_mN(const Body& body, const Eigen::VectorXd& u_mm);

// Of forces on the nodes (mN, 3 a node), those on what each support fixes, summed: one a support.
[[nodiscard]] std::vector<Eigen::Vector3d> sum_of_each_support(const Body& body, const Eigen::VectorXd& force_mN);

// Of 3 values a node.
[[nodiscard]] Eigen::Vector3d sum_of(const Eigen::VectorXd& values);

}  // namespace glisson::mechanics
