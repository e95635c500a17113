#include "mechanics/contact/internal/tool_stations.h"

#include <fmt/format.h>

#include "base/stopwatch.h"

namespace glisson::mechanics {
namespace {

// Of Newton's method in each round of the augmented Lagrangian.
constexpr double residual_of_a_round = 1e-5;
constexpr int newton_steps_of_a_round = 40;

LargeContact outcome(const AugmentedLagrangian& lagrangian, StaticResult state, const std::vector<ContactTool>& tools,
                     bool rested, std::size_t station, std::size_t stations, const ContactOptions& options);

}  // namespace

Result<LargeContact> go_through(const std::vector<std::vector<ContactTool>>& stations, const Unknowns& unknowns,
                                const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                                const ContactOptions& options, Eigen::VectorXd from_mm,
                                const std::vector<OpenedBody::Wall>& walls, const Progress& progress) {
  GLISSON_ASSERT(!stations.empty());
  const Stopwatch watch;
  Minimum minimum{std::move(from_mm)};
  auto lagrangian =
      AugmentedLagrangian::create(body, stations.front(), options, unknowns.displacement_mm(minimum.x_mm), walls);
  if (!lagrangian) return failure(std::move(lagrangian.error()));
  const Eigen::VectorXd rest_mm = Eigen::VectorXd::Zero(loads.dead_mN.size());
  const auto count = static_cast<double>(stations.size());
  AppliedLoads now = loads;
  std::size_t station = 0;
  bool rested = true;
  for (; station < stations.size() && rested; ++station) {
    const std::vector<ContactTool>& tools = stations[station];
    progress.report(static_cast<double>(station) / count, GLISSON_TEXT("Moving the tools"));
    now = lagrangian->with_pulls(walls.empty() ? loads : share_of(loads, static_cast<double>(station + 1) / count),
                                 tools);
    const TotalPotential alone(body, static_potentials(body, materials, now));
    const double scale_mN = free_values(body.resolved.fixed, force_mN(boundary_and_loads(body, now), rest_mm)).norm();
    const MinimiseOptions newton{residual_of_a_round, newton_steps_of_a_round, body.options.memory_limit_bytes};
    const auto came_to_rest = lagrangian->equilibrate(tools, {alone, scale_mN, unknowns, minimum, newton, progress});
    if (!came_to_rest) return failure(came_to_rest.error());
    rested = *came_to_rest;
  }
  StaticResult state = state_of(body, materials, lagrangian->displacement_mm(), now, lagrangian->force_mN());
  LargeContact contact =
      outcome(*lagrangian, std::move(state), stations[station - 1], rested, station, stations.size(), options);
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  return contact;
}

namespace {

LargeContact outcome(const AugmentedLagrangian& lagrangian, StaticResult state, const std::vector<ContactTool>& tools,
                     bool rested, std::size_t station, std::size_t stations, const ContactOptions& options) {
  LargeContact contact{std::move(state), lagrangian.contacts(tools), lagrangian.report()};
  contact.result.relative_residual = contact.report.relative_residual;
  contact.result.iterations = contact.report.rounds;
  contact.report.energy_uJ = contact.result.strain_energy_uJ;
  contact.report.largest_strain = contact.result.largest_strain;
  contact.report.inverted_cells = contact.result.inverted_cells;
  contact.report.converged = rested;
  contact.result.status = rested ? SolveStatus::converged : SolveStatus::not_converged;
  contact.result.why_stopped =
      rested ? fmt::format("The tools rest: the relative residual is {:.1e}, the deepest penetration {:.3f} mm.",
                           contact.result.relative_residual, contact.report.penetration_mm)
             : fmt::format(
                   "At step {} of {} of the tools' way no rest was found: a tool reaches {:.2f} mm into the "
                   "surface (tolerance {:.2f}), which still moves by {:.2f} mm.",
                   station, stations, contact.report.penetration_mm, options.penetration_tolerance_mm,
                   contact.report.movement_mm);
  return contact;
}

}  // namespace
}  // namespace glisson::mechanics
