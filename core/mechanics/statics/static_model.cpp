#include "mechanics/statics/static_model.h"

#include <fmt/format.h>

#include "base/stopwatch.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/strain.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/solvers/constrained_system.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/validity.h"

namespace glisson::mechanics {

// Everything that only the loads do not change.
struct StaticModel::Impl : Body {
  std::vector<int> mutual_points;
  std::optional<ConstrainedSystem> system;           // or
  std::shared_ptr<const DisplacementSolver> solver;  // in its place
  Cost cost;

  [[nodiscard]] Result<Eigen::MatrixXd> forces_of(const std::vector<Loads>& cases) const;
  [[nodiscard]] std::vector<ConstrainedSolution> solutions(const Eigen::MatrixXd& force_mN,
                                                           const Eigen::MatrixXd& fixed_mm) const;
  [[nodiscard]] std::vector<StaticResult> solve(const Eigen::MatrixXd& force_mN, const Eigen::MatrixXd& fixed_mm) const;
  [[nodiscard]] StaticResult result_of(const ConstrainedSolution& solution, const Eigen::VectorXd& force_mN) const;
};

Result<StaticModel> StaticModel::create(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                        std::vector<Support> supports, const StaticOptions& options,
                                        const Progress& progress, const std::vector<int>& mutual_points) {
  return create_in_order(std::move(mesh), std::move(youngs_kPa), std::move(supports), options, progress, mutual_points,
                         nullptr);
}

StaticModel StaticModel::solved_by(Body body, std::shared_ptr<const DisplacementSolver> solver) {
  auto parts = std::make_shared<Impl>();
  static_cast<Body&>(*parts) = std::move(body);
  GLISSON_ASSERT(parts->resolved.prescribed_mm.size() == 0);
  parts->cost = solver->cost();
  parts->solver = std::move(solver);
  return StaticModel(std::move(parts));
}

Result<StaticModel> StaticModel::with_moduli(std::vector<double> youngs_kPa, const StaticOptions& options,
                                             const Progress& progress) const {
  if (impl_->solver) return impl_->solver->with_moduli(std::move(youngs_kPa), options, progress);
  return create_in_order(impl_->mesh, std::move(youngs_kPa), impl_->supports, options, progress, impl_->mutual_points,
                         impl_->system->order());
}

Result<StaticModel> StaticModel::create_in_order(geometry::TetMesh mesh, std::vector<double> youngs_kPa,
                                                 std::vector<Support> supports, const StaticOptions& options,
                                                 const Progress& progress, const std::vector<int>& mutual_points,
                                                 std::shared_ptr<const EliminationOrder> known) {
  const Stopwatch watch;
  progress.report(0.0, GLISSON_TEXT("Checking the model"));
  if (options.anisotropy) {
    if (auto sound = check_anisotropy(*options.anisotropy, options.poisson_ratio); !sound) {
      return failure(std::move(sound.error()));
    }
  }
  auto body = prepare_body(std::move(mesh), std::move(youngs_kPa), std::move(supports), options, Holding::required);
  if (!body) return failure(std::move(body.error()));
  if (!body->resolved.ligaments.empty()) {
    return failure("not-available",
                   GLISSON_TEXT("A ligament only pulls, so it is not linear: look for the equilibrium by steps."));
  }
  auto parts = std::make_shared<Impl>();
  static_cast<Body&>(*parts) = std::move(*body);

  progress.report(0.05, GLISSON_TEXT("Assembling the stiffness"));
  if (progress.cancelled()) return cancelled();
  parts->mutual_points = mutual_points;
  std::vector<int> mutual;
  for (const int point : mutual_points) {
    for (int axis = 0; axis < 3; ++axis) mutual.push_back(3 * parts->layout.node_of_point[point] + axis);
  }
  auto system = ConstrainedSystem::create(assemble_stiffness(*parts), parts->resolved.fixed, options.memory_limit_bytes,
                                          progress.part(0.1, 1.0), std::move(known), std::move(mutual));
  if (!system) return failure(std::move(system.error()));
  parts->system = std::move(*system);
  if (options.factor_precision == StaticOptions::FactorPrecision::single) {
    parts->system->keep_factor_in_single_precision();
  }
  parts->cost = {watch.seconds(), parts->system->free_unknowns(), parts->system->matrix_bytes(),
                 parts->system->factor() ? parts->system->factor()->bytes() : 0};
  return StaticModel(std::move(parts));
}

Result<StaticResult> StaticModel::solve(const Loads& loads) const {
  return solve_each({loads}).map([](std::vector<StaticResult> results) { return std::move(results.front()); });
}

Result<std::vector<StaticResult>> StaticModel::solve_each(const std::vector<Loads>& cases) const {
  const auto force_mN = impl_->forces_of(cases);
  if (!force_mN) return failure(force_mN.error());
  const Eigen::VectorXd& prescribed_mm = impl_->resolved.prescribed_mm;
  if (prescribed_mm.size() == 0) return impl_->solve(*force_mN, {});
  return impl_->solve(*force_mN, prescribed_mm.replicate(1, force_mN->cols()));
}

Result<void> StaticModel::Responses::usable() const {
  if (converged) return {};
  return failure("not-converged",
                 GLISSON_TEXT("The body's answer to a force on its surface was not found: the relative residual "
                              "stayed at {0}."),
                 {fmt::format("{:.1e}", relative_residual)});
}

Result<StaticModel::Responses> StaticModel::respond_each(const std::vector<Loads>& cases) const {
  return impl_->forces_of(cases).map([&](const Eigen::MatrixXd& force_mN) { return respond(force_mN, Digits::seen); });
}

// On the nodes, a column a case.
Result<Eigen::MatrixXd> StaticModel::Impl::forces_of(const std::vector<Loads>& cases) const {
  Eigen::MatrixXd force_mN(3 * static_cast<Eigen::Index>(layout.nodes()), static_cast<Eigen::Index>(cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto column = load_vector(mesh, layout, boundary, options.density_kg_mm3, cases[i]);
    if (!column) return failure(column.error());
    force_mN.col(static_cast<Eigen::Index>(i)) = *column;
  }
  return force_mN;
}

Result<StaticResult> StaticModel::solve_nodal(const NodalLoad& load) const {
  const Eigen::Index unknowns = 3 * static_cast<Eigen::Index>(impl_->layout.nodes());
  const bool has_prescribed = load.prescribed_displacement_mm.size() > 0;
  if (load.force_mN.size() != unknowns || (has_prescribed && load.prescribed_displacement_mm.size() != unknowns)) {
    return failure("load-invalid", GLISSON_TEXT("Nodal loads need {0} values: three a node."),
                   {std::to_string(unknowns)});
  }
  if (!load.force_mN.allFinite() || (has_prescribed && !load.prescribed_displacement_mm.allFinite())) {
    return failure("load-invalid", GLISSON_TEXT("A nodal load is not a finite number."));
  }
  return std::move(impl_->solve(load.force_mN, load.prescribed_displacement_mm).front());
}

StaticModel::Responses StaticModel::respond(const Eigen::MatrixXd& force_mN, Digits digits) const {
  Eigen::MatrixXd u;
  double relative_residual = 0;
  bool is_seen_right = false;
  if (impl_->solver) {
    auto solution = impl_->solver->solve(force_mN);
    u = std::move(solution.displacement_mm);
    relative_residual = solution.relative_residual;
  } else {
    auto response = impl_->system->respond(force_mN, digits);
    u = std::move(response.u);
    relative_residual = response.relative_residual;
    is_seen_right = response.is_seen_right;
  }
  const bool converged = (is_seen_right || relative_residual <= impl_->options.relative_tolerance) && u.allFinite();
  return {std::move(u), relative_residual, converged};
}

const std::vector<int>& StaticModel::mutual_points() const { return impl_->mutual_points; }

Eigen::MatrixXd StaticModel::mutual_compliance() const {
  return impl_->solver ? Eigen::MatrixXd() : impl_->system->mutual_compliance();  // a solver's body has no such points
}

std::vector<StaticResult> StaticModel::Impl::solve(const Eigen::MatrixXd& force_mN,
                                                   const Eigen::MatrixXd& fixed_mm) const {
  const Stopwatch watch;
  const auto solved = solutions(force_mN, fixed_mm);
  std::vector<StaticResult> results;
  results.reserve(solved.size());
  for (std::size_t i = 0; i < solved.size(); ++i) {
    results.push_back(result_of(solved[i], force_mN.col(static_cast<Eigen::Index>(i))));
  }
  for (StaticResult& result : results) {
    result.step_ms = 1e3 * watch.seconds() / static_cast<double>(results.size());
  }
  return results;
}

std::vector<ConstrainedSolution> StaticModel::Impl::solutions(const Eigen::MatrixXd& force_mN,
                                                              const Eigen::MatrixXd& fixed_mm) const {
  if (!solver) {
    return system->solve(force_mN, fixed_mm,
                         {.tolerance = options.relative_tolerance, .max_refinements = options.max_refinements});
  }
  const DisplacementSolver::Solution together = solver->solve(force_mN);
  std::vector<ConstrainedSolution> each(static_cast<std::size_t>(force_mN.cols()));
  for (std::size_t i = 0; i < each.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    each[i].u = together.displacement_mm.col(column);
    each[i].reaction = together.reaction_mN.col(column);
    each[i].relative_residual = together.relative_residual;
    each[i].converged = together.relative_residual <= options.relative_tolerance && each[i].u.allFinite();
  }
  return each;
}

StaticResult StaticModel::Impl::result_of(const ConstrainedSolution& solution, const Eigen::VectorXd& force_mN) const {
  StaticResult result;
  result.status = solution.converged ? SolveStatus::converged : SolveStatus::not_converged;
  result.why_stopped =
      solution.converged
          ? fmt::format("The relative residual {:.1e} is within the tolerance {:.1e}.", solution.relative_residual,
                        options.relative_tolerance)
          : fmt::format(
                "The relative residual stayed at {:.1e}, above the tolerance {:.1e}: the equations are too "
                "badly conditioned (Poisson's ratio too near 1/2, flat cells, or a body that is barely held).",
                solution.relative_residual, options.relative_tolerance);
  result.relative_residual = solution.relative_residual;
  result.iterations = solution.iterations;
  result.setup_s = cost.setup_s;

  const Eigen::VectorXd& u = solution.u;
  set_displacements(*this, u, result);

  const Eigen::VectorXd spring_force_mN = foundation_force_mN(*this, u);
  result.applied_force_mN = sum_of(force_mN);
  result.fixed_reaction_mN = sum_of(solution.reaction);
  result.support_reaction_mN = sum_of_each_support(*this, solution.reaction);
  result.foundation_reaction_mN = sum_of(spring_force_mN);
  result.foundation_energy_uJ = -0.5 * u.dot(spring_force_mN);
  result.external_work_uJ = 0.5 * u.dot(force_mN);
  // u.Ku/2 without another product with K: K u is the load, what the supports add, and the residual (negligible).
  result.strain_energy_uJ = 0.5 * u.dot(force_mN + solution.reaction) - result.foundation_energy_uJ;

  const StrainRange strains = strain_range(mesh, layout, u);
  result.largest_strain = strains.largest_strain;
  result.inverted_cells = strains.inverted_cells;
  const Validity validity{true, strains.largest_strain, strains.inverted_cells};
  if (validity.state() != AnswerState::within) result.notes.push_back(validity.sentence().message());
  // 1e-16 of rounding over a condition beyond 1e14 leaves no correct digit, however small the residual.
  if (system && system->factor() && system->factor()->reciprocal_condition() < 1e-14) {
    result.notes.emplace_back("The body is barely held: small errors of its data change the displacements a lot.");
  }
  if (result.max_displacement_mm == 0 && force_mN.norm() > 0) {
    result.notes.emplace_back("Every load acts on what is held: nothing moves.");
  }
  return result;
}

const ReducedFunctions* StaticModel::reduced_functions() const {
  return impl_->solver ? impl_->solver->reduced_functions() : nullptr;
}
const Body& StaticModel::body() const { return *impl_; }
const geometry::TetMesh& StaticModel::mesh() const { return impl_->mesh; }
const std::vector<double>& StaticModel::youngs_kPa() const { return impl_->youngs_kPa; }
const NodeLayout& StaticModel::nodes() const { return impl_->layout; }
const StaticOptions& StaticModel::options() const { return impl_->options; }
const std::vector<Support>& StaticModel::supports() const { return impl_->supports; }
StaticModel::Cost StaticModel::cost() const { return impl_->cost; }

Result<std::size_t> StaticModel::faces_touched_by(const Eigen::Vector3d& center_mm, double radius_mm) const {
  return faces_within(impl_->boundary, center_mm, radius_mm).map([](const auto& faces) { return faces.size(); });
}

std::vector<Eigen::Vector3d> StaticModel::displacement_at(const StaticResult& result,
                                                          const std::vector<PointInMesh>& places) const {
  return mechanics::displacement_at(*impl_, result, places);
}

std::vector<double> StaticModel::von_mises_kPa(const StaticResult& result) const {
  const Eigen::VectorXd u_mm = nodal_displacements(impl_->layout, result);
  if (const auto& anisotropy = impl_->options.anisotropy) {
    return von_mises_of_cells(impl_->mesh, impl_->layout, impl_->youngs_kPa,
                              unit_tangent(*anisotropy, impl_->options.poisson_ratio), u_mm);
  }
  return von_mises_of_cells(impl_->mesh, impl_->layout, impl_->materials, u_mm);
}

Result<StaticResult> solve_static(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                                  const Loads& loads, const StaticOptions& options, const Progress& progress) {
  return StaticModel::create(std::move(mesh), std::move(youngs_kPa), std::move(supports), options, progress)
      .and_then([&](const StaticModel& model) { return model.solve(loads); });
}

}  // namespace glisson::mechanics
