#include "mechanics/statics/equilibrium.h"

#include <fmt/format.h>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/stopwatch.h"
#include "mechanics/elements/boundary_potential.h"
#include "mechanics/elements/strain.h"
#include "mechanics/solvers/internal/newton.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/internal/elastic_potential.h"
#include "mechanics/statics/validity.h"

namespace glisson::mechanics {
namespace {

constexpr double times_its_size = 1000, unlimited = std::numeric_limits<double>::infinity();

double size_of(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : body.layout.positions_mm) box.extend(position);
  return box.diagonal().norm();
}

}  // namespace

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials, const Loads& loads,
                                      const NewtonOptions& options, const Progress& progress) {
  return applied_loads(body, loads, gas_on(materials)).and_then([&](const AppliedLoads& applied) {
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
  MinimiseOptions descent_options{options.relative_tolerance, options.max_steps, body.options.memory_limit_bytes};
  Eigen::VectorXd u_mm = Eigen::VectorXd::Zero(loads.dead_mN.size());
  double carried = 0.0, part = 1.0, relative_residual = 0.0;
  int steps = 0, halvings = 0;
  bool hopeless = false;
  while (carried < 1.0 && halvings <= options.max_halvings && steps < options.max_steps_in_all && !hopeless) {
    progress.report(carried, GLISSON_TEXT("Looking for the equilibrium"));
    const double next = std::min(1.0, carried + part);
    const ElasticPotential balance(body, materials, loads, next);
    // At rest the first direction is the answer of small strain.
    descent_options.longest_mm = steps == 0 ? times_its_size * size_of(body) : unlimited;
    auto descent = minimise(balance, body.resolved.fixed, balance.scale_mN(), u_mm, descent_options, progress);
    if (!descent) return failure(std::move(descent.error()));
    hopeless = descent->hopeless;
    steps += descent->steps;
    relative_residual = descent->relative_residual;
    if (descent->converged) {
      u_mm = std::move(descent->u_mm);
      carried = next;
    } else {
      part *= 0.5;
      ++halvings;
    }
  }
  progress.report(1.0, GLISSON_TEXT("Solved"));

  StaticResult result =
      state_of(body, materials, u_mm, {carried * loads.dead_mN, carried * loads.follower_pressure_kPa},
               Eigen::VectorXd::Zero(u_mm.size()));
  result.status = carried == 1.0 ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = relative_residual;
  result.iterations = steps;
  result.why_stopped =
      carried == 1.0 ? fmt::format("The relative residual {:.1e} is within the tolerance {:.1e}.", relative_residual,
                                   options.relative_tolerance)
      : hopeless
          ? fmt::format(
                "The body is far too soft for its load: by small strain it would move more than {:g} times its own "
                "size. Check the units of stiffness and load.",
                times_its_size)
          : fmt::format(
                "Beyond {:.1f} % of the load no equilibrium was found within {} Newton steps: the relative "
                "residual stayed at {:.1e}, above the tolerance {:.1e}.",
                100.0 * carried, options.max_steps, relative_residual, options.relative_tolerance);
  result.step_ms = 1e3 * watch.seconds();
  return result;
}

Gas gas_on(const std::vector<Material>& materials) {
  return std::holds_alternative<SmallStrain>(materials.front()) ? Gas::stays_as_at_rest : Gas::follows_the_surface;
}

StaticResult state_of(const Body& body, const std::vector<Material>& materials, const Eigen::VectorXd& u_mm,
                      const AppliedLoads& loads, const Eigen::VectorXd& damping_mN) {
  StaticResult result;
  set_displacements(body, u_mm, result);
  const Eigen::VectorXd around_mN = boundary_force_mN(body, loads.follower_pressure_kPa, u_mm);
  const Eigen::VectorXd gas_mN = around_mN - boundary_force_mN(body, 0.0, u_mm);
  const Eigen::VectorXd foundations_mN = foundation_force_mN(body, u_mm);
  const Eigen::VectorXd unbalanced_mN =
      loads.dead_mN + damping_mN + around_mN - internal_force_mN(body, materials, u_mm);
  result.applied_force_mN = sum_of(loads.dead_mN) + sum_of(gas_mN);
  result.fixed_reaction_mN = -sum_of(unbalanced_mN - free_values(body.resolved.fixed, unbalanced_mN));
  result.foundation_reaction_mN = sum_of(foundations_mN);
  result.ligament_reaction_mN = sum_of(ligament_force_mN(body, u_mm));
  result.strain_energy_uJ = strain_energy_uJ(body, materials, u_mm);
  result.foundation_energy_uJ = boundary_energy_uJ(body, loads.follower_pressure_kPa, u_mm);
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

}  // namespace glisson::mechanics
