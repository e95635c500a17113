#include "mechanics/large_contact.h"

#include <fmt/format.h>

#include "mechanics/body_landscape.h"
#include "mechanics/frame_landscape.h"
#include "mechanics/pressing.h"
#include "mechanics/stopwatch.h"

namespace glisson::mechanics {
namespace {

constexpr double residual_of_a_round = 1e-5;
constexpr int newton_steps_of_a_round = 40;

// Through the stations, up to one where `rest_under` finds no rest; gives back how many were gone to.
template <typename RestUnder>
Result<std::size_t> go_through(const std::vector<std::vector<HandTool>>& stations, const RestUnder& rest_under,
                               bool& rested, const Progress& progress) {
  std::size_t station = 0;
  for (rested = true; station < stations.size() && rested; ++station) {
    progress.report(double(station) / double(stations.size()), GLISSON_TEXT("Moving the tools"));
    const Result<bool> came_to_rest = rest_under(stations[station]);
    if (!came_to_rest) return failure(came_to_rest.error());
    rested = *came_to_rest;
  }
  return station;
}

LargeContact outcome(const Pressing& pressing, StaticResult state, const std::vector<HandTool>& tools, bool rested,
                     std::size_t station, std::size_t stations, const ContactOptions& options);

}  // namespace

Result<LargeContact> find_equilibrium_in_contact(const Body& body, const std::vector<Material>& materials,
                                                 const AppliedLoads& loads,
                                                 const std::vector<std::vector<HandTool>>& stations,
                                                 const ContactOptions& options, const Progress& progress,
                                                 const std::vector<OpenedBody::Wall>& walls) {
  GLISSON_ASSERT(!stations.empty());
  const Stopwatch watch;
  Eigen::VectorXd from_mm = Eigen::VectorXd::Zero(loads.dead_mN.size());
  if (walls.empty()) {
    auto standing = find_equilibrium(body, materials, loads, {}, progress.part(0.0, 0.1));
    if (!standing) return failure(std::move(standing.error()));
    if (!standing->may_be_used()) return LargeContact{std::move(*standing), {}, {}};
    from_mm = nodal_displacements(body, *standing);
  }
  auto pressing = Pressing::create(body, stations.front(), options, std::move(from_mm), walls);
  if (!pressing) return failure(std::move(pressing.error()));
  AppliedLoads all = loads;
  std::size_t station_now = 0;
  const auto rest_under = [&](const std::vector<HandTool>& tools) {
    AppliedLoads standing_loads = loads;
    if (!walls.empty()) {
      const double part = static_cast<double>(++station_now) / static_cast<double>(stations.size());
      standing_loads.dead_mN *= part;
      standing_loads.gas_kPa *= part;
    }
    all = pressing->with_pulls(std::move(standing_loads), tools);
    const BodyLandscape alone(body, materials, all);
    const auto settle = [&](const Landscape& with_tools, double scale_mN, const Eigen::VectorXd& start_mm) {
      return descend(with_tools, body.resolved.held, scale_mN, start_mm,
                     {residual_of_a_round, newton_steps_of_a_round, body.options.memory_limit_bytes}, progress);
    };
    return pressing->rest_under(tools, {alone, alone.scale_mN(), settle});
  };
  bool rested = true;
  const auto station = go_through(stations, rest_under, rested, progress.part(0.1, 1.0));
  if (!station) return failure(station.error());
  StaticResult state = state_of(body, materials, pressing->displacement_mm(), all, pressing->force_mN());
  LargeContact contact =
      outcome(*pressing, std::move(state), stations[*station - 1], rested, *station, stations.size(), options);
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  return contact;
}

Result<void> check_tools_on_frames(const std::vector<HandTool>& tools) {
  for (const HandTool& tool : tools) {
    const auto* grasp = std::get_if<Grasp>(&tool.what);
    if (grasp == nullptr || std::holds_alternative<double>(grasp->drawn)) continue;
    return failure(Error{"not-available",
                         GLISSON_TEXT("By the meshfree engine a grasper pulls with a force; {0} has a displacement."),
                         {tool.id},
                         GLISSON_TEXT("Give it a pull, or take finite elements."),
                         {}});
  }
  return {};
}

Result<LargeContact> find_equilibrium_in_contact(const MeshfreeModel& model, const AppliedLoads& loads,
                                                 const std::vector<std::vector<HandTool>>& stations,
                                                 const ContactOptions& options, const Progress& progress) {
  GLISSON_ASSERT(!stations.empty());
  const Stopwatch watch;
  const MeshfreeBody& frames = model.body();
  if (auto checked = check_tools_on_frames(stations.front()); !checked) return failure(std::move(checked.error()));
  Eigen::VectorXd q_mm = Eigen::VectorXd::Zero(frames.basis->unknowns());
  const std::vector<std::uint8_t> nothing_held(static_cast<std::size_t>(q_mm.size()), 0);
  // The frames come to rest, and the places with them.
  const auto settle = [&](const Landscape& of_places, double scale_mN, const Eigen::VectorXd&) -> Result<Descent> {
    auto descent =
        descend(FrameLandscape(frames, of_places), nothing_held, scale_mN, q_mm,
                {residual_of_a_round, newton_steps_of_a_round, frames.body.options.memory_limit_bytes}, progress);
    if (!descent) return descent;
    q_mm = descent->u_mm;
    descent->u_mm = frames.basis->displacement(q_mm);
    return descent;
  };
  auto pressing = Pressing::create(frames.body, stations.front(), options, frames.basis->displacement(q_mm));
  if (!pressing) return failure(std::move(pressing.error()));
  AppliedLoads all = loads;
  const auto rest_under = [&](const std::vector<HandTool>& tools) {
    all = pressing->with_pulls(loads, tools);
    const BodyLandscape alone(frames.body, frames.materials, all);
    return pressing->rest_under(tools, {alone, alone.scale_mN(), settle});
  };
  bool rested = true;
  const auto station = go_through(stations, rest_under, rested, progress);
  if (!station) return failure(station.error());
  const Eigen::VectorXd& u_mm = pressing->displacement_mm();
  StaticResult state = state_of(frames.body, frames.materials, u_mm, all, pressing->force_mN());
  state.held_reaction_mN = sum_of(frames.holding_force_mN(u_mm));
  LargeContact contact =
      outcome(*pressing, std::move(state), stations[*station - 1], rested, *station, stations.size(), options);
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  return contact;
}

namespace {

LargeContact outcome(const Pressing& pressing, StaticResult state, const std::vector<HandTool>& tools, bool rested,
                     std::size_t station, std::size_t stations, const ContactOptions& options) {
  LargeContact contact{std::move(state), pressing.contacts(tools), pressing.report()};
  contact.result.relative_residual = contact.report.relative_residual;
  contact.result.iterations = contact.report.rounds;
  contact.report.energy_uJ = contact.result.strain_energy_uJ;
  contact.report.inverted_cells = static_cast<int>(contact.result.inverted_cells);
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
