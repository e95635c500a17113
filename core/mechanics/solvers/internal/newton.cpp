#include "mechanics/solvers/internal/newton.h"

#include <cmath>
#include <memory>

#include "mechanics/solvers/constrained_system.h"

namespace glisson::mechanics {
namespace {

Result<Eigen::VectorXd> newton_direction(const Objective& objective, const std::vector<std::uint8_t>& fixed,
                                         const Eigen::VectorXd& u_mm, const Eigen::VectorXd& residual_mN,
                                         std::uint64_t memory_limit_bytes, const Progress& progress,
                                         std::shared_ptr<const EliminationOrder>& order) {
  const auto along = [&](Tangent which) {
    return ConstrainedSystem::create(objective.tangent(u_mm, which), fixed, memory_limit_bytes, Progress{}, order);
  };
  if (progress.cancelled()) return cancelled();
  auto system = along(Tangent::exact);
  if (!system && system.error().code == "factorisation-failed") system = along(Tangent::positive);
  if (!system) return failure(std::move(system.error()));
  order = system->order();
  // Newton needs a direction, not digits: one refinement is plenty.
  return system->solve(residual_mN, {}, {.target = 1e-8, .max_refinements = 1}).front().u;
}

}  // namespace

Result<NewtonResult> minimise(const Objective& objective, const std::vector<std::uint8_t>& fixed, double scale_mN,
                              const Eigen::VectorXd& start_mm, const MinimiseOptions& options,
                              const Progress& progress) {
  NewtonResult result{start_mm};
  if (scale_mN == 0) {
    result.converged = true;
    return result;
  }
  const auto residual_at = [&](const Eigen::VectorXd& u_mm) { return free_values(fixed, objective.force_mN(u_mm)); };
  double energy_uJ = objective.energy_uJ(result.u_mm);
  Eigen::VectorXd residual_mN = residual_at(result.u_mm);
  std::shared_ptr<const EliminationOrder> order;  // of all tangents
  for (;; ++result.steps) {
    result.relative_residual = residual_mN.norm() / scale_mN;
    result.converged = result.relative_residual <= options.relative_tolerance;
    if (result.converged || result.steps == options.max_steps) return result;

    if (progress.cancelled()) return cancelled();
    const auto direction =
        newton_direction(objective, fixed, result.u_mm, residual_mN, options.memory_limit_bytes, progress, order);
    if (!direction) return failure(direction.error());
    // Also where it is no number.
    result.hopeless = result.steps == 0 && !(direction->lpNorm<Eigen::Infinity>() <= options.longest_mm);
    if (result.hopeless) return result;
    const double slope_uJ = residual_mN.dot(*direction);

    // Backtracking until the energy falls by a little of what its slope promises (Armijo). Near the end the fall drowns
    // in rounding, about 1e-14 of the energies that it is the difference of; there the residual decides.
    constexpr double promised = 1e-4;
    const double rounding_uJ = 1e-13 * (std::abs(energy_uJ) + objective.energy_scale_uJ(result.u_mm));
    bool stepped = false;
    for (double length = 1.0; length > 1e-8 && !stepped; length *= 0.5) {
      const Eigen::VectorXd trial_mm = result.u_mm + length * *direction;
      const double trial_uJ = objective.energy_uJ(trial_mm);
      if (!(trial_uJ <= energy_uJ - promised * length * slope_uJ + rounding_uJ)) continue;
      Eigen::VectorXd trial_residual_mN = residual_at(trial_mm);
      if (promised * slope_uJ < rounding_uJ && trial_residual_mN.norm() >= residual_mN.norm()) continue;
      result.u_mm = trial_mm;
      energy_uJ = trial_uJ;
      residual_mN = std::move(trial_residual_mN);
      stepped = true;
    }
    if (!stepped) return result;
  }
}

Eigen::VectorXd free_values(const std::vector<std::uint8_t>& fixed, Eigen::VectorXd values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (fixed[static_cast<std::size_t>(i)]) values[i] = 0.0;
  }
  return values;
}

}  // namespace glisson::mechanics
