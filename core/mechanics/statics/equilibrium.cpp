#include "mechanics/statics/equilibrium.h"

#include <fmt/format.h>
#include <cmath>
#include <limits>

#include "base/stopwatch.h"
#include "geometry/surface.h"
#include "mechanics/elements/strain.h"
#include "mechanics/potentials/follower_pressure.h"
#include "mechanics/potentials/ligament.h"
#include "mechanics/solvers/constrained_system.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/internal/unknowns.h"
#include "mechanics/statics/validity.h"

namespace glisson::mechanics {
namespace {

constexpr double times_its_size = 1000, unlimited = std::numeric_limits<double>::infinity();

Result<Eigen::VectorXd> supports_moved(const Body& body, const TotalPotential& potential, const Eigen::VectorXd& u_mm,
                                       double share, const Progress& progress);
double moving_force_mN(const Body& body, const TotalPotential& potential, const Eigen::VectorXd& rest_mm, double share);

}  // namespace

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials, const Loads& loads,
                                      const NewtonOptions& options, const Progress& progress) {
  return applied_loads(body, loads, pressure_kind_of(materials)).and_then([&](const AppliedLoads& applied) {
    return find_equilibrium(body, materials, applied, options, progress);
  });
}

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& force_mN, const NewtonOptions& options,
                                      const Progress& progress) {
  return find_equilibrium(body, materials, AppliedLoads{force_mN, 0.0}, options, progress);
}

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const AppliedLoads& loads, const NewtonOptions& options,
                                      const Progress& progress) {
  GLISSON_ASSERT(materials.size() == body.mesh.cells.size() && loads.dead_mN.size() == 3 * body.layout.nodes());
  const Stopwatch watch;
  const auto carried = carry_load(NodalUnknowns(body), body, materials, loads, options, progress);
  if (!carried) return failure(carried.error());
  StaticResult result = state_of(body, materials, carried->x_mm, share_of(loads, carried->share),
                                 Eigen::VectorXd::Zero(carried->x_mm.size()));
  const bool whole = carried->share == 1.0;
  result.status = whole ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = carried->relative_residual;
  result.iterations = carried->steps;
  result.why_stopped =
      whole ? fmt::format("The relative residual {:.1e} is within the tolerance {:.1e}.", carried->relative_residual,
                          options.relative_tolerance)
      : carried->hopeless
          ? fmt::format(
                "The body is far too soft for its load: by small strain it would move more than {:g} times its own "
                "size. Check the units of stiffness and load.",
                times_its_size)
          : fmt::format(
                "Beyond {:.1f} % of the load no equilibrium was found within {} Newton steps: the relative "
                "residual stayed at {:.1e}, above the tolerance {:.1e}.",
                100.0 * carried->share, options.max_steps, carried->relative_residual, options.relative_tolerance);
  result.step_ms = 1e3 * watch.seconds();
  return result;
}

Result<CarriedLoad> carry_load(const Unknowns& unknowns, const Body& body, const std::vector<Material>& materials,
                               const AppliedLoads& loads, const NewtonOptions& options, const Progress& progress) {
  MinimiseOptions newton{options.relative_tolerance, options.max_steps, body.options.memory_limit_bytes};
  const Eigen::VectorXd rest_mm = Eigen::VectorXd::Zero(loads.dead_mN.size());
  CarriedLoad carried{unknowns.at_rest()};
  double part = 1.0;
  for (int halvings = 0; carried.share < 1.0 && halvings <= options.max_halvings &&
                         carried.steps < options.max_steps_in_all && !carried.hopeless;) {
    progress.report(carried.share, GLISSON_TEXT("Looking for the equilibrium"));
    const double next = std::min(1.0, carried.share + part);
    const AppliedLoads now = share_of(loads, next);
    // At rest ligaments and capsule pull at nothing: what is left is the load.
    double scale_mN = unknowns.size_mN(force_mN(boundary_and_loads(body, now), rest_mm));
    const TotalPotential potential(body, static_potentials(body, materials, now));
    Eigen::VectorXd start_mm = carried.x_mm;
    if (body.resolved.prescribed_mm.size() > 0) {
      scale_mN += moving_force_mN(body, potential, rest_mm, next);
      auto moved = supports_moved(body, potential, carried.x_mm, next - carried.share, progress);
      if (!moved) return failure(std::move(moved.error()));
      start_mm = std::move(*moved);
    }
    // At rest the first direction is the answer of small strain.
    newton.longest_mm = carried.steps == 0
                            ? times_its_size * geometry::bounding_box(body.layout.positions_mm).diagonal_mm()
                            : unlimited;
    auto found = unknowns.minimum_of(potential, scale_mN, start_mm, newton, progress);
    if (!found) return failure(std::move(found.error()));
    carried.hopeless = found->hopeless;
    carried.steps += found->steps;
    carried.relative_residual = found->relative_residual;
    if (found->converged) {
      carried.x_mm = std::move(found->u_mm);
      carried.share = next;
    } else {
      part *= 0.5;
      ++halvings;
    }
  }
  progress.report(1.0, GLISSON_TEXT("Solved"));
  return carried;
}

AppliedLoads share_of(const AppliedLoads& loads, double share) {
  return {share * loads.dead_mN, share * loads.follower_pressure_kPa};
}

PressureKind pressure_kind_of(const std::vector<Material>& materials) {
  return std::holds_alternative<SmallStrain>(materials.front()) ? PressureKind::dead : PressureKind::follower;
}

StaticResult state_of(const Body& body, const std::vector<Material>& materials, const Eigen::VectorXd& u_mm,
                      const AppliedLoads& loads, const Eigen::VectorXd& damping_mN) {
  StaticResult result;
  set_displacements(body, u_mm, result);
  const Potentials around = boundary_potentials(body, loads.follower_pressure_kPa);
  const Eigen::VectorXd around_mN = force_mN(around, u_mm);
  Eigen::VectorXd gas_mN = Eigen::VectorXd::Zero(u_mm.size()), ligaments_mN = gas_mN;
  if (loads.follower_pressure_kPa != 0) FollowerPressure(body, loads.follower_pressure_kPa).add_force(u_mm, gas_mN);
  LigamentPotential(body).add_force(u_mm, ligaments_mN);
  const Eigen::VectorXd unbalanced_mN =
      loads.dead_mN + damping_mN + around_mN - internal_force_mN(body, materials, u_mm);
  result.applied_force_mN = sum_of(loads.dead_mN) + sum_of(gas_mN);
  const Eigen::VectorXd reaction_mN = free_values(body.resolved.fixed, unbalanced_mN) - unbalanced_mN;
  result.fixed_reaction_mN = sum_of(reaction_mN);
  result.support_reaction_mN = sum_of_each_support(body, reaction_mN);
  result.foundation_reaction_mN = sum_of(foundation_force_mN(body, u_mm));
  result.ligament_reaction_mN = sum_of(ligaments_mN);
  result.strain_energy_uJ = strain_energy_uJ(body, materials, u_mm);
  result.foundation_energy_uJ = energy_uJ(around, u_mm);
  result.external_work_uJ = u_mm.dot(loads.dead_mN);
  const StrainMeasure measure =
      std::holds_alternative<SmallStrain>(materials.front()) ? StrainMeasure::small : StrainMeasure::stretch;
  const StrainRange strains = strain_range(body.mesh, body.layout, u_mm, measure);
  result.largest_strain = strains.largest_strain;
  result.inverted_cells = strains.inverted_cells;
  const bool small =
      std::holds_alternative<SmallStrain>(materials.front()) || std::holds_alternative<Corotational>(materials.front());
  const Validity validity{true, strains.largest_strain, strains.inverted_cells,
                          strain_limit(small ? MaterialLaw::corotational : MaterialLaw::neo_hookean)};
  if (validity.state() != AnswerState::within) result.notes.push_back(validity.sentence().message());
  if (result.max_displacement_mm == 0 && loads.dead_mN.norm() > 0) {
    result.notes.emplace_back("Every load acts on what is held: nothing moves.");
  }
  return result;
}

namespace {

// Where the body stands when its supports move on by a share of what is prescribed, by the tangent at u: a start for
// Newton's method in which the interior has come along.
Result<Eigen::VectorXd> supports_moved(const Body& body, const TotalPotential& potential, const Eigen::VectorXd& u_mm,
                                       double share, const Progress& progress) {
  if (progress.cancelled()) return cancelled();
  const auto system = ConstrainedSystem::create(potential.tangent(u_mm, Tangent::positive), body.resolved.fixed,
                                                body.options.memory_limit_bytes);
  if (!system) return failure(system.error());
  const Eigen::VectorXd move_mm = share * body.resolved.prescribed_mm;
  const Eigen::VectorXd still_mN = Eigen::VectorXd::Zero(u_mm.size());
  return Eigen::VectorXd(u_mm + system->solve(still_mN, move_mm, {.target = 1e-8, .max_refinements = 1}).front().u);
}

// How large the forces are, at rest, with which moving supports push what is free: what a residual is measured by.
double moving_force_mN(const Body& body, const TotalPotential& potential, const Eigen::VectorXd& rest_mm,
                       double share) {
  const Eigen::SparseMatrix<double> lower = potential.tangent(rest_mm, Tangent::positive);
  const Eigen::VectorXd move_mm = share * body.resolved.prescribed_mm;
  return free_values(body.resolved.fixed, lower.selfadjointView<Eigen::Lower>() * move_mm).norm();
}

}  // namespace
}  // namespace glisson::mechanics
