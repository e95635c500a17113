#pragma once
// Equilibrium by the meshfree engine: one body, prepared once, solved for as many loads as one likes. The counterpart
// of static_model.h (law linear) and equilibrium.h (the others), with far fewer unknowns. What a few hundred handles
// cannot follow of a deformation is missing. The body is that much too stiff, never too soft, but for the springs that
// hold it (meshfree_body.h).

#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/meshfree/meshfree_nodes.h"
#include "mechanics/scenario/scenario.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

struct MeshfreeBody;

class MeshfreeModel {
 public:
  // Checks everything, makes nodes and shape functions, assembles and factorises. `mesh` is open along the cuts
  // (open_cuts); `youngs_kPa` has one value a cell; `options.order` is not read. Failures: those of
  // prepare_meshfree_body.
  static Result<MeshfreeModel> create(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                      const std::vector<Support>& supports, const ChosenLaw& law,
                                      const StaticOptions& options = {}, const MeshfreeOptions& meshfree = {},
                                      const std::vector<Cut>& cuts = {}, const Progress& progress = {});

  // Equilibrium under all the loads together. `iterations` are conjugate gradients' with law linear and no ligament,
  // Newton's otherwise. A solve that misses the tolerance is a result that may not be used, and says so. Failures:
  // those of load_vector; "cancelled".
  [[nodiscard]] Result<StaticResult> solve(const Loads& loads, const NewtonOptions& options = {},
                                           const Progress& progress = {}) const;
  // The same under given loads on the places of the quadratic layout.
  [[nodiscard]] Result<StaticResult> solve(const AppliedLoads& loads, const NewtonOptions& options = {},
                                           const Progress& progress = {}) const;

  // The same body as a StaticModel, for tools in contact (contact/contact.h) and cuts that advance (cutting/opening.h).
  // Failures: "not-available" (more nodes than are factorised), those of check_meshfree_static.
  [[nodiscard]] Result<StaticModel> static_model() const;

  [[nodiscard]] const MeshfreeBody& body() const;
  [[nodiscard]] const geometry::TetMesh& mesh() const;
  [[nodiscard]] const NodeLayout& places() const;
  [[nodiscard]] const ShapeFunctions& shape_functions() const;
  [[nodiscard]] const std::vector<double>& youngs_kPa() const;
  // The displacement at places in the body (see locate_points), by the cells' own shape functions.
  [[nodiscard]] std::vector<Eigen::Vector3d> displacement_at(const StaticResult& result,
                                                             const std::vector<PointInMesh>& places) const;
  // Von Mises stress (kPa) at each cell's centroid.
  [[nodiscard]] std::vector<double> von_mises_kPa(const StaticResult& result) const;

  struct Cost {
    double setup_s = 0;
    std::size_t unknowns = 0;
    std::uint64_t matrix_bytes = 0;
    std::uint64_t factor_bytes = 0;  // of what preconditions: the factor itself, or two levels (reduced_solver.h)
  };
  [[nodiscard]] Cost cost() const;

 private:
  struct Impl;
  class StaticSolver;
  explicit MeshfreeModel(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;  // immutable and shared
};

// What a meshfree StaticModel can be of. Failure: "not-available" (another law than linear, anisotropy, ligaments).
Result<void> check_meshfree_static(const ChosenLaw& law, const std::vector<Support>& supports,
                                   const StaticOptions& options);

}  // namespace glisson::mechanics
