#pragma once
// The nodes of the meshfree engine and their shape functions, made offline from a body and its stiffness.
//
// Nodes stand at the centroids of a Voronoi decomposition of the body (section 4.2 of the dissertation;
// voronoi_nodes.h). Each takes the modulus of the voxel that it stands in. Shape functions follow Faure et al. 2011
// (see compliance_distance.h). They depend on the compliance distance d_i to the nodes. So a stiff part moves as one,
// and deformation gathers where the body is soft, whatever the number of nodes:
//
//   w_i = psi(d_i / r_i) / sum over k of psi(d_k / r_k),   psi(t) = 1 - t for t < 1, else 0
//
// Node i's cell, in the Voronoi decomposition by compliance, meets others' cells. The reach r_i is `overlap` times the
// distance to the farthest place where it does, and more than reaches its own cell. Twice that distance is where the
// farthest neighbour stands. The weights are not negative, sum to 1, are continuous, and reach about as far as the
// nodes around. Along a bar between two nodes they fall straight with the compliance distance. That is how a bar of any
// stiffness stretches. They are kept as values at the points of the mesh, linear between. The mesh is the background
// over which is integrated; no unknown is tied to it. Smoother psi were tried on the cantilever of table 6.1 and were
// up to 4 % less exact.

#include <Eigen/Core>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/cut.h"
#include "mechanics/scenario/meshfree_options.h"

namespace glisson::mechanics {

struct ShapeFunctions {
  std::vector<Eigen::Vector3d> nodes_mm;
  std::vector<double> node_youngs_kPa;
  std::vector<double> node_volumes_mm3;
  int fixed_nodes = 0;  // how many of the last nodes are those of fixed points (meshfree_body.h)

  // Of mesh point p: the nodes that act on it, ascending, in [starts[p], starts[p + 1]), and their weights.
  std::vector<std::size_t> starts;
  std::vector<int> nodes;
  std::vector<double> weights;
};

// The mesh must have passed check_tetrahedra, or be what open_cuts made of one that has; `cuts` are the cuts that it
// was opened along. Where a cut leaves a part without a node, that part gets one. Failures: "meshfree-options" (a
// number out of range), those of voronoi_nodes; "cancelled".
Result<ShapeFunctions> shape_functions_of(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                          const MeshfreeOptions& options, const std::vector<Cut>& cuts = {},
                                          const Progress& progress = {});

// Young's modulus of each cell as the nodes give it: the mean over its corners of their weighted moduli.
[[nodiscard]] std::vector<double> youngs_of_nodes_kPa(const geometry::TetMesh& mesh, const ShapeFunctions& shape);

}  // namespace glisson::mechanics
