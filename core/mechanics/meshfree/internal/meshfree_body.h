#pragma once
// A body made ready for the meshfree engine, offline: nodes, shape functions, and the stiffness at rest over handles
// (reduced_matrix.h). Equilibrium and motion both start from one.
//
// Points are fixed by a penalty, because no unknown stands at them. A place has a spring in each fixed direction,
// `penalty_factor` times as stiff as the body itself is there. They give way by about that part of a cell's
// deformation, and results say by how much. Points fixed in all directions have a node of their own, one in each part
// of the body that has any. Else the nodes that reach them would be fixed with them.

#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/elements/body.h"
#include "mechanics/meshfree/internal/reduced_operator.h"
#include "mechanics/meshfree/meshfree_nodes.h"
#include "mechanics/potentials/elastic.h"

namespace glisson::mechanics {

struct MeshfreeBody {
  Body body;  // laid out with quadratic cells
  MaterialLaw law = MaterialLaw::linear;
  ShapeFunctions shape;
  std::shared_ptr<const AffineBasis> basis;
  std::vector<Material> materials;    // one a cell
  std::vector<double> penalty_mN_mm;  // springs, 3 a place; 0 where free
  Lists handles_meeting;
  ReducedOperator::Form form;
  ReducedOperator rest_stiffness;  // of the body, its foundations, its capsule and `penalty_mN_mm`
  double setup_s = 0;

  static constexpr double penalty_factor = 1e3;

  // What the springs of fixed points push with (mN, 3 a place) where the places have moved by u.
  [[nodiscard]] Eigen::VectorXd penalty_force_mN(const Eigen::VectorXd& u_mm) const;
  // The tangent at u, with what holds and surrounds the body, the gas at `pressure_kPa`.
  [[nodiscard]] ReducedOperator tangent(const Eigen::VectorXd& u_mm, Tangent which, double pressure_kPa = 0) const;
  // A tangent of the places (its lower triangle) and what holds, assembled whatever the number of handles.
  [[nodiscard]] ReducedMatrix assembled(Eigen::SparseMatrix<double> lower) const;
  // The same, in either form, of any symmetric matrix over the places.
  [[nodiscard]] ReducedOperator over_handles(const Eigen::SparseMatrix<double>& lower) const;
};

// `mesh` is open along the cuts (open_cuts). Failures: those of prepare_body and of shape_functions_of.
Result<MeshfreeBody> prepare_meshfree_body(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                           const std::vector<Support>& supports, const ChosenLaw& chosen,
                                           StaticOptions options, const MeshfreeOptions& meshfree,
                                           const std::vector<Cut>& cuts, Holding holding,
                                           const Progress& progress = {});

}  // namespace glisson::mechanics
