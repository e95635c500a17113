#include "mechanics/equilibrium.h"

#include <fmt/format.h>
#include <cmath>

#include "mechanics/constrained_system.h"
#include "mechanics/load_vector.h"
#include "mechanics/stopwatch.h"
#include "mechanics/strain.h"

namespace glisson::mechanics {
namespace {

// One body under one load, as a function of the displacement.
struct Balance {
  const Body& body;
  const std::vector<Material>& materials;

  // Total energy (uJ) under the force.
  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm, const Eigen::VectorXd& force_mN) const {
    return strain_energy_uJ(body, materials, u_mm) - 0.5 * u_mm.dot(foundation_force_mN(body, u_mm)) -
           force_mN.dot(u_mm);
  }
  // What is not balanced (mN); zero where the supports take it.
  [[nodiscard]] Eigen::VectorXd residual_mN(const Eigen::VectorXd& u_mm, const Eigen::VectorXd& force_mN) const {
    Eigen::VectorXd residual = force_mN + foundation_force_mN(body, u_mm) - internal_force_mN(body, materials, u_mm);
    return of_the_free(std::move(residual));
  }
  [[nodiscard]] Eigen::VectorXd of_the_free(Eigen::VectorXd values) const {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (body.resolved.held[static_cast<std::size_t>(i)]) values[i] = 0.0;
    }
    return values;
  }
};

struct Descent {
  Eigen::VectorXd u_mm;
  double relative_residual = 0;
  int steps = 0;
  bool converged = false;
};

Result<Descent> descend(const Balance& balance, const Eigen::VectorXd& force_mN, const Eigen::VectorXd& start_mm,
                        const NewtonOptions& options, const Progress& progress);
Result<Eigen::VectorXd> newton_direction(const Balance& balance, const Eigen::VectorXd& u_mm,
                                         const Eigen::VectorXd& residual_mN, const Progress& progress);
StaticResult result_of(const Balance& balance, const Eigen::VectorXd& u_mm, const Eigen::VectorXd& force_mN);

}  // namespace

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials, const Loads& loads,
                                      const NewtonOptions& options, const Progress& progress) {
  return load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, loads)
      .and_then([&](const Eigen::VectorXd& force_mN) {
        return find_equilibrium(body, materials, force_mN, options, progress);
      });
}

Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& force_mN, const NewtonOptions& options,
                                      const Progress& progress) {
  GLISSON_ASSERT(materials.size() == body.mesh.cells.size() && force_mN.size() == 3 * body.layout.nodes());
  const Stopwatch watch;
  const Balance balance{body, materials};
  Eigen::VectorXd u_mm = Eigen::VectorXd::Zero(force_mN.size());
  double carried = 0.0, part = 1.0, relative_residual = 0.0;
  int steps = 0, halvings = 0;
  while (carried < 1.0 && halvings <= options.max_halvings) {
    progress.report(carried, "Looking for the equilibrium");
    const double next = std::min(1.0, carried + part);
    auto descent = descend(balance, next * force_mN, u_mm, options, progress);
    if (!descent) return failure(std::move(descent.error()));
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
  progress.report(1.0, "Solved");

  StaticResult result = result_of(balance, u_mm, carried * force_mN);
  result.status = carried == 1.0 ? SolveStatus::converged : SolveStatus::not_converged;
  result.relative_residual = relative_residual;
  result.iterations = steps;
  result.why_stopped =
      carried == 1.0 ? fmt::format("The relative residual {:.1e} is within the tolerance {:.1e}.", relative_residual,
                                   options.relative_tolerance)
                     : fmt::format(
                           "Beyond {:.1f} % of the load no equilibrium was found within {} Newton steps: the relative "
                           "residual stayed at {:.1e}, above the tolerance {:.1e}.",
                           100.0 * carried, options.max_steps, relative_residual, options.relative_tolerance);
  result.step_ms = 1e3 * watch.seconds();
  return result;
}

namespace {

Result<Descent> descend(const Balance& balance, const Eigen::VectorXd& force_mN, const Eigen::VectorXd& start_mm,
                        const NewtonOptions& options, const Progress& progress) {
  const double scale_mN = balance.of_the_free(force_mN).norm();
  Descent descent{start_mm};
  if (scale_mN == 0) {  // nothing loads what is free: rest, where it starts
    descent.converged = true;
    return descent;
  }
  double energy_uJ = balance.energy_uJ(descent.u_mm, force_mN);
  Eigen::VectorXd residual_mN = balance.residual_mN(descent.u_mm, force_mN);
  for (;; ++descent.steps) {
    descent.relative_residual = residual_mN.norm() / scale_mN;
    descent.converged = descent.relative_residual <= options.relative_tolerance;
    if (descent.converged || descent.steps == options.max_steps) return descent;

    if (progress.cancelled()) return cancelled();
    const auto direction = newton_direction(balance, descent.u_mm, residual_mN, progress);
    if (!direction) return failure(direction.error());
    const double slope_uJ = residual_mN.dot(*direction);

    // Backtracking until the energy falls by a little of what its slope promises (Armijo). Near the end the fall drowns
    // in rounding, about 1e-14 of the energies that it is the difference of; there the residual decides.
    constexpr double promised = 1e-4;
    const double rounding_uJ = 1e-13 * (std::abs(energy_uJ) + std::abs(force_mN.dot(descent.u_mm)));
    bool stepped = false;
    for (double length = 1.0; length > 1e-8 && !stepped; length *= 0.5) {
      const Eigen::VectorXd trial_mm = descent.u_mm + length * *direction;
      const double trial_uJ = balance.energy_uJ(trial_mm, force_mN);
      if (!(trial_uJ <= energy_uJ - promised * length * slope_uJ + rounding_uJ)) continue;
      Eigen::VectorXd trial_residual_mN = balance.residual_mN(trial_mm, force_mN);
      if (promised * slope_uJ < rounding_uJ && trial_residual_mN.norm() >= residual_mN.norm()) continue;
      descent.u_mm = trial_mm;
      energy_uJ = trial_uJ;
      residual_mN = std::move(trial_residual_mN);
      stepped = true;
    }
    if (!stepped) return descent;
  }
}

Result<Eigen::VectorXd> newton_direction(const Balance& balance, const Eigen::VectorXd& u_mm,
                                         const Eigen::VectorXd& residual_mN, const Progress& progress) {
  const Body& body = balance.body;
  const auto along = [&](Tangent which) {
    return ConstrainedSystem::create(tangent_stiffness(body, balance.materials, u_mm, which), body.resolved.held,
                                     body.options.memory_limit_bytes, Progress{});
  };
  if (progress.cancelled()) return cancelled();
  auto system = along(Tangent::exact);
  if (!system && system.error().code == "factorisation-failed") system = along(Tangent::positive);
  if (!system) return failure(std::move(system.error()));
  // Newton needs a direction, not digits: one refinement is plenty.
  return system->solve(residual_mN, {}, {.target = 1e-8, .max_refinements = 1}).front().u;
}

StaticResult result_of(const Balance& balance, const Eigen::VectorXd& u_mm, const Eigen::VectorXd& force_mN) {
  const Body& body = balance.body;
  StaticResult result;
  set_displacements(body, u_mm, result);
  const Eigen::VectorXd spring_force_mN = foundation_force_mN(body, u_mm);
  const Eigen::VectorXd unbalanced_mN = force_mN + spring_force_mN - internal_force_mN(body, balance.materials, u_mm);
  result.applied_force_mN = sum_of(force_mN);
  result.held_reaction_mN = -sum_of(unbalanced_mN - balance.of_the_free(unbalanced_mN));
  result.foundation_reaction_mN = sum_of(spring_force_mN);
  result.strain_energy_uJ = strain_energy_uJ(body, balance.materials, u_mm);
  result.foundation_energy_uJ = -0.5 * u_mm.dot(spring_force_mN);
  result.external_work_uJ = u_mm.dot(force_mN);
  const StrainRange strains = strain_range(body.mesh, body.layout, u_mm, StrainMeasure::stretch);
  result.largest_strain = strains.largest_strain;
  result.inverted_cells = strains.inverted_cells;
  if (strains.inverted_cells > 0) {
    result.notes.push_back(
        fmt::format("{} cells are turned inside out: the load is more than this mesh or this material can bear.",
                    strains.inverted_cells));
  }
  if (result.max_displacement_mm == 0 && force_mN.norm() > 0) {
    result.notes.emplace_back("Every load acts on what is held: nothing moves.");
  }
  return result;
}

}  // namespace
}  // namespace glisson::mechanics
