#pragma once
// Static linear elasticity at small strain: one body, its supports, factorised once, solved for as many loads as
// one likes.
//
// Quadratic tetrahedra with straight edges (ten nodes), which do not lock as Poisson's ratio nears 1/2; linear
// ones (four nodes) exist to be compared with. One Young's modulus a cell, one Poisson's ratio, isotropic unless the
// options say a fibre direction (anisotropy.h):
//   sigma = lambda tr(eps) I + 2 mu eps,  eps = (grad u + grad u^T) / 2,
//   lambda = E nu / ((1 + nu) (1 - 2 nu)),  mu = E / (2 (1 + nu))
// (any text on elasticity, e.g. Bower, Applied Mechanics of Solids, 3.2). Not valid where strains or rotations
// are large: results say how large they became.
//
// By default the stiffness matrix's factor answers. An engine with other unknowns may stand in its place, with the same
// body, supports and loads (meshfree/meshfree_model.h).
//
// Lengths mm, forces mN, moduli and stresses kPa, energies uJ, patient coordinates (LPS), the rest shape throughout.

#include <cstdint>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/elements/static_options.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/solvers/digits.h"
#include "mechanics/statics/reduced_functions.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

class DisplacementSolver;
class EliminationOrder;

// Forces and given displacements for callers that integrate their own (manufactured solutions, contact):
// 3 values a node, x y z, in the order of NodeLayout.
struct NodalLoad {
  Eigen::VectorXd force_mN;                    // 3 * nodes
  Eigen::VectorXd prescribed_displacement_mm;  // 3 * nodes, read where a node is fixed; empty: fixed nodes stay
};

class StaticModel {
 public:
  // Checks everything, assembles and factorises. `youngs_kPa` has one value a cell. Failures: those of
  // check_tetrahedra; "modulus-invalid" (the first cell is named), "poisson-invalid", "support-empty" (a support that
  // names nothing), "grain-invalid". Fails with "body-free" where it is not fixed enough to be in equilibrium (the free
  // motion is named). Fails with "too-large" where the factor would not fit the memory limit. Fails with
  // "factorisation-failed" or "cancelled". Fails with "not-available" for a ligament, which only pulls:
  // find_equilibrium knows it. `mutual_points` are points of the mesh whose answers to each other are wanted
  // (mutual_compliance), each once.
  static Result<StaticModel> create(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                    std::vector<Support> supports, const StaticOptions& options = {},
                                    const Progress& progress = {}, const std::vector<int>& mutual_points = {});
  // Of a body that nothing prescribes a displacement of; the solver is of that body.
  static StaticModel solved_by(Body body, std::shared_ptr<const DisplacementSolver> solver);

  // This body of other moduli, at the cost of the numbers alone: the order of elimination is this one's. `options` may
  // differ in what a cell is made of. Failures: create's.
  [[nodiscard]] Result<StaticModel> with_moduli(std::vector<double> youngs_kPa, const StaticOptions& options,
                                                const Progress& progress = {}) const;

  // Equilibrium under all the loads together and the supports' prescribed displacements. Failures:
  // "tool-touches-nothing" (how far the nearest face is),
  // "load-invalid" (a number that is not finite). A solve that misses the tolerance is a result that may not be
  // used, and says so.
  [[nodiscard]] Result<StaticResult> solve(const Loads& loads) const;

  // One result for each set of loads; together they cost less than one at a time.
  [[nodiscard]] Result<std::vector<StaticResult>> solve_each(const std::vector<Loads>& cases) const;
  [[nodiscard]] Result<StaticResult> solve_nodal(const NodalLoad& load) const;

  // The displacements of all nodes (mm, 3 a node) under each column of forces (mN), fixed nodes still. They are for
  // callers that ask often and sum up. What was left is in `relative_residual`. A factor in single precision answers
  // to some six digits, which are `seen`, in a third of the time that it takes for all.
  struct Responses {
    Eigen::MatrixXd displacement_mm;
    double relative_residual = 0;
    bool converged = false;  // within the options' tolerance, all of them; or right to 1e-5, for what is seen

    [[nodiscard]] Result<void> usable() const;  // else "not-converged"
  };
  [[nodiscard]] Responses respond(const Eigen::MatrixXd& force_mN, Digits digits = Digits::all) const;
  // As seen, to each set of loads, without what the supports prescribe. Failures: those of solve.
  [[nodiscard]] Result<Responses> respond_each(const std::vector<Loads>& cases) const;

  // As they were given.
  [[nodiscard]] const std::vector<int>& mutual_points() const;
  // How the mutual points move (mm) by a force of 1 mN on each, 3 rows and 3 columns a point. It is what `respond`
  // would give for 3 loads a point. It costs the inverse of a dense matrix of that size, 8 bytes an entry.
  [[nodiscard]] Eigen::MatrixXd mutual_compliance() const;

  // What displacements follow where it is not the nodes themselves; else nullptr.
  [[nodiscard]] const ReducedFunctions* reduced_functions() const;
  [[nodiscard]] const Body& body() const;
  [[nodiscard]] const geometry::TetMesh& mesh() const;
  [[nodiscard]] const std::vector<double>& youngs_kPa() const;
  [[nodiscard]] const NodeLayout& nodes() const;
  [[nodiscard]] const StaticOptions& options() const;
  [[nodiscard]] const std::vector<Support>& supports() const;

  // How many faces of the surface a tool of that centre and radius pushes on. Failure: "tool-touches-nothing".
  [[nodiscard]] Result<std::size_t> faces_touched_by(const Eigen::Vector3d& center_mm, double radius_mm) const;

  // The displacement at places in the body (see locate_points), by the cells' own shape functions.
  [[nodiscard]] std::vector<Eigen::Vector3d> displacement_at(const StaticResult& result,
                                                             const std::vector<PointInMesh>& places) const;

  // Von Mises stress (kPa) at each cell's centroid.
  [[nodiscard]] std::vector<double> von_mises_kPa(const StaticResult& result) const;

  struct Cost {
    double setup_s = 0;
    std::size_t unknowns = 0;
    std::uint64_t matrix_bytes = 0;
    std::uint64_t factor_bytes = 0;
  };
  [[nodiscard]] Cost cost() const;

 private:
  struct Impl;
  explicit StaticModel(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  static Result<StaticModel> create_in_order(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                             std::vector<Support> supports, const StaticOptions& options,
                                             const Progress& progress, const std::vector<int>& mutual_points,
                                             std::shared_ptr<const EliminationOrder> known);
  std::shared_ptr<const Impl> impl_;  // immutable and shared: copies are cheap, solving from several threads is safe
};

// Displacements under forces, in place of the stiffness matrix's factor. Safe from several threads.
class DisplacementSolver {
 public:
  virtual ~DisplacementSolver() = default;
  struct Solution {
    Eigen::MatrixXd displacement_mm, reaction_mN;  // 3 values a node; of the nodes that are fixed, zero elsewhere
    double relative_residual = 0;                  // the worst of the columns
  };
  [[nodiscard]] virtual Solution solve(const Eigen::MatrixXd& force_mN) const = 0;
  // The same for the body of other moduli. Failures: those of StaticModel::create.
  [[nodiscard]] virtual Result<StaticModel> with_moduli(std::vector<double> youngs_kPa, const StaticOptions& options,
                                                        const Progress& progress) const = 0;
  [[nodiscard]] virtual StaticModel::Cost cost() const = 0;
  [[nodiscard]] virtual const ReducedFunctions* reduced_functions() const { return nullptr; }
};

// The one-shot: builds the model, solves once.
Result<StaticResult> solve_static(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                                  const Loads& loads, const StaticOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::mechanics
