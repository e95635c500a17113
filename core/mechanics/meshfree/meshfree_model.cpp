#include "mechanics/meshfree/meshfree_model.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/strain.h"
#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/internal/reduced_potential.h"
#include "mechanics/meshfree/internal/reduced_solver.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

struct MeshfreeModel::Impl {
  MeshfreeBody handles;
  ReducedPreconditioner preconditioner;
  MeshfreeOptions options;
  double setup_s;
};

namespace {

// Conjugate gradients go this far where they go without a factor; 200, the dissertation's limit, is for steps in time.
constexpr int maximum_iterations = 5000;

StaticResult result_of(const MeshfreeBody& handles, const Eigen::VectorXd& q_mm, const AppliedLoads& loads);

}  // namespace

Result<MeshfreeModel> MeshfreeModel::create(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                            const std::vector<Support>& supports, const ChosenLaw& law,
                                            const StaticOptions& options, const MeshfreeOptions& meshfree,
                                            const std::vector<Cut>& cuts, const Progress& progress) {
  const Stopwatch watch;
  auto handles = prepare_meshfree_body(mesh, youngs_kPa, supports, law, options, meshfree, cuts, Holding::required,
                                       progress.part(0.0, 0.8));
  if (!handles) return failure(std::move(handles.error()));
  progress.report(0.8, GLISSON_TEXT("Factorising"));
  if (progress.cancelled()) return cancelled();
  auto preconditioner = ReducedPreconditioner::of(handles->rest_stiffness, options.memory_limit_bytes);
  return MeshfreeModel(
      std::make_shared<const Impl>(Impl{std::move(*handles), std::move(preconditioner), meshfree, watch.seconds()}));
}

Result<StaticResult> MeshfreeModel::solve(const Loads& loads, const NewtonOptions& options,
                                          const Progress& progress) const {
  const MeshfreeBody& handles = impl_->handles;
  return applied_loads(handles.body, loads, pressure_kind_of(handles.materials))
      .and_then([&](const AppliedLoads& applied) { return solve(applied, options, progress); });
}

Result<StaticResult> MeshfreeModel::solve(const AppliedLoads& loads, const NewtonOptions& options,
                                          const Progress& progress) const {
  const Stopwatch watch;
  const MeshfreeBody& handles = impl_->handles;
  GLISSON_ASSERT(loads.dead_mN.size() == 3 * handles.body.layout.nodes());
  StaticResult result;
  if (handles.law == MaterialLaw::linear && handles.body.resolved.ligaments.empty()) {
    const double tolerance = handles.body.options.relative_tolerance;
    const Eigen::VectorXd force_mN = handles.basis->reduce(loads.dead_mN);
    const ReducedSolution solution =
        conjugate_gradients(handles.rest_stiffness, impl_->preconditioner, force_mN,
                            Eigen::VectorXd::Zero(force_mN.size()), tolerance, maximum_iterations);
    result = result_of(handles, solution.x, loads);
    result.external_work_uJ *= 0.5;
    result.status = solution.converged ? SolveStatus::converged : SolveStatus::not_converged;
    result.relative_residual = solution.relative_residual;
    result.iterations = solution.iterations;
    result.why_stopped = fmt::format(
        "The relative residual {:.1e} is {} the tolerance {:.1e} after {} conjugate gradients.",
        solution.relative_residual, solution.converged ? "within" : "above", tolerance, solution.iterations);
  } else {
    const auto carried = carry_load(HandleUnknowns(handles), handles.body, handles.materials, loads, options, progress);
    if (!carried) return failure(carried.error());
    const double share = carried->share;
    result = result_of(handles, carried->x_mm, share_of(loads, share));
    result.status = share == 1.0 ? SolveStatus::converged : SolveStatus::not_converged;
    result.relative_residual = carried->relative_residual;
    result.iterations = carried->steps;
    result.why_stopped =
        fmt::format("{:.1f} % of the load are carried, to a relative residual of {:.1e} (tolerance {:.1e}).",
                    100.0 * share, carried->relative_residual, options.relative_tolerance);
  }
  result.setup_s = impl_->setup_s;
  result.step_ms = 1e3 * watch.seconds();
  return result;
}

// P by its columns, for those who split functions.
class HandleFunctions : public ReducedFunctions {
 public:
  explicit HandleFunctions(const MeshfreeBody& handles) : handles_(handles) {}
  [[nodiscard]] int unknowns() const override { return handle_size; }
  [[nodiscard]] std::vector<int> acting_on(int point) const override {
    std::vector<int> acting;
    const AffineBasis& basis = *handles_.basis;
    for (const auto* share = basis.shares_begin(point); share != basis.shares_end(point); ++share) {
      acting.push_back(share->handle);
    }
    std::sort(acting.begin(), acting.end());
    return acting;
  }
  [[nodiscard]] Eigen::SparseMatrix<double> columns(const std::vector<int>& functions) const override {
    return handles_.basis->columns(functions);
  }
  [[nodiscard]] const std::vector<double>& springs_mN_mm() const override { return handles_.penalty_mN_mm; }

 private:
  const MeshfreeBody& handles_;
};

// u = P (P^T K P)^-1 P^T f, P being how places follow handles.
class MeshfreeModel::StaticSolver : public DisplacementSolver {
 public:
  explicit StaticSolver(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)), functions_(impl_->handles) {}

  [[nodiscard]] Solution solve(const Eigen::MatrixXd& force_mN) const override {
    const MeshfreeBody& handles = impl_->handles;
    Eigen::MatrixXd on_handles(handles.basis->unknowns(), force_mN.cols());
    for (Eigen::Index k = 0; k < force_mN.cols(); ++k) on_handles.col(k) = handles.basis->reduce(force_mN.col(k));
    constexpr double part = 0.5;  // of the tolerance, within which a StaticModel's answers are taken
    const ReducedSolutions solved = solve_together(handles.rest_stiffness, impl_->preconditioner, on_handles,
                                                   part * handles.body.options.relative_tolerance, maximum_iterations);
    Solution solution{Eigen::MatrixXd(force_mN.rows(), force_mN.cols()),
                      Eigen::MatrixXd(force_mN.rows(), force_mN.cols()), solved.relative_residual};
    for (Eigen::Index k = 0; k < force_mN.cols(); ++k) {
      solution.displacement_mm.col(k) = handles.basis->displacement(solved.x.col(k));
      solution.reaction_mN.col(k) = handles.penalty_force_mN(solution.displacement_mm.col(k));
    }
    return solution;
  }

  [[nodiscard]] Result<StaticModel> with_moduli(std::vector<double> youngs_kPa, const StaticOptions& options,
                                                const Progress& progress) const override {
    const Body& body = impl_->handles.body;
    return MeshfreeModel::create(body.mesh, youngs_kPa, body.supports, MaterialLaw::linear, options, impl_->options, {},
                                 progress)
        .and_then([](const MeshfreeModel& model) { return model.static_model(); });
  }

  [[nodiscard]] StaticModel::Cost cost() const override {
    const Cost cost = MeshfreeModel(impl_).cost();
    return {cost.setup_s, cost.unknowns, cost.matrix_bytes, cost.factor_bytes};
  }

  [[nodiscard]] const ReducedFunctions* reduced_functions() const override { return &functions_; }

 private:
  std::shared_ptr<const Impl> impl_;
  HandleFunctions functions_;
};

Result<void> check_meshfree_static(const ChosenLaw& law, const std::vector<Support>& supports,
                                   const StaticOptions& options) {
  const bool only_pulls = std::any_of(supports.begin(), supports.end(), [](const Support& support) {
    return std::holds_alternative<Ligament>(support.how);
  });
  if (law.law == MaterialLaw::linear && !options.anisotropy && !only_pulls) return {};
  return failure(
      Error{"not-available",
            GLISSON_TEXT("With tools in the hand the meshfree engine knows a linear, isotropic liver without "
                         "ligaments."),
            {},
            GLISSON_TEXT("Take finite elements for others."),
            {}});
}

Result<StaticModel> MeshfreeModel::static_model() const {
  const MeshfreeBody& handles = impl_->handles;
  if (auto can_be = check_meshfree_static(handles.law, handles.body.supports, handles.body.options); !can_be) {
    return failure(std::move(can_be.error()));
  }
  if (handles.rest_stiffness.assembled() == nullptr || impl_->preconditioner.whole_factor() == nullptr) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("{0} meshfree nodes are too many to be taken in hand: their matrix is not "
                                      "factorised within seconds."),
                         {std::to_string(handles.basis->handles())},
                         GLISSON_TEXT("Take fewer nodes, or let `simulate` solve for them."),
                         {}});
  }
  return StaticModel::solved_by(handles.body, std::make_shared<const StaticSolver>(impl_));
}

const MeshfreeBody& MeshfreeModel::body() const { return impl_->handles; }
const geometry::TetMesh& MeshfreeModel::mesh() const { return impl_->handles.body.mesh; }
const NodeLayout& MeshfreeModel::places() const { return impl_->handles.body.layout; }
const ShapeFunctions& MeshfreeModel::shape_functions() const { return impl_->handles.shape; }
const std::vector<double>& MeshfreeModel::youngs_kPa() const { return impl_->handles.body.youngs_kPa; }

std::vector<Eigen::Vector3d> MeshfreeModel::displacement_at(const StaticResult& result,
                                                            const std::vector<PointInMesh>& places) const {
  return mechanics::displacement_at(impl_->handles.body, result, places);
}

std::vector<double> MeshfreeModel::von_mises_kPa(const StaticResult& result) const {
  const Body& body = impl_->handles.body;
  const Eigen::VectorXd u_mm = nodal_displacements(body.layout, result);
  return impl_->handles.law == MaterialLaw::linear ? von_mises_of_cells(body.mesh, body.layout, body.materials, u_mm)
                                                   : von_mises_of_cells(body, impl_->handles.materials, u_mm);
}

MeshfreeModel::Cost MeshfreeModel::cost() const {
  return {impl_->setup_s, static_cast<std::size_t>(impl_->handles.basis->unknowns()),
          impl_->handles.rest_stiffness.bytes(), impl_->preconditioner.bytes()};
}

namespace {

StaticResult result_of(const MeshfreeBody& handles, const Eigen::VectorXd& q_mm, const AppliedLoads& loads) {
  const Eigen::VectorXd u_mm = handles.basis->displacement(q_mm);
  StaticResult result = state_of(handles.body, handles.materials, u_mm, loads, Eigen::VectorXd::Zero(u_mm.size()));
  result.fixed_reaction_mN = sum_of(handles.penalty_force_mN(u_mm));
  const double points_a_node = static_cast<double>(handles.body.mesh.points_mm.size()) / handles.basis->handles();
  if (points_a_node < 4) {
    result.notes.push_back(
        fmt::format("The mesh has {:.1f} points for each meshfree node: their handles then describe one motion in many "
                    "ways, and solving takes far longer. A finer mesh or fewer nodes would do.",
                    points_a_node));
  }
  double slip_mm = 0;
  for (std::size_t i = 0; i < handles.penalty_mN_mm.size(); ++i) {
    if (handles.penalty_mN_mm[i] > 0) slip_mm = std::max(slip_mm, std::abs(u_mm[static_cast<Eigen::Index>(i)]));
  }
  if (slip_mm > 0.01 * result.max_displacement_mm && slip_mm > 1e-6) {
    result.notes.push_back(fmt::format("What is held gives way by up to {:.2g} mm.", slip_mm));
  }
  return result;
}

}  // namespace
}  // namespace glisson::mechanics
