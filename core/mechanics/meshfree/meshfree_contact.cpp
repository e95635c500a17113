#include "mechanics/meshfree/meshfree_contact.h"

#include "base/stopwatch.h"
#include "mechanics/contact/internal/tool_stations.h"
#include "mechanics/meshfree/internal/reduced_potential.h"
#include "mechanics/statics/internal/elastic_potential.h"

namespace glisson::mechanics {

Result<void> check_tools_on_meshfree(const std::vector<ContactTool>& tools) {
  for (const ContactTool& tool : tools) {
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
                                                 const std::vector<std::vector<ContactTool>>& stations,
                                                 const ContactOptions& options, const Progress& progress) {
  GLISSON_ASSERT(!stations.empty());
  const Stopwatch watch;
  const MeshfreeBody& handles = model.body();
  if (auto checked = check_tools_on_meshfree(stations.front()); !checked) return failure(std::move(checked.error()));
  Eigen::VectorXd q_mm = Eigen::VectorXd::Zero(handles.basis->unknowns());
  const std::vector<std::uint8_t> nothing_held(static_cast<std::size_t>(q_mm.size()), 0);
  // The handles come to rest, and the places with them.
  const auto settle = [&](const Potential& of_places, double scale_mN, const Eigen::VectorXd&) -> Result<NewtonResult> {
    auto descent =
        minimise(ReducedPotential(handles, of_places), nothing_held, scale_mN, q_mm,
                 {residual_of_a_round, newton_steps_of_a_round, handles.body.options.memory_limit_bytes}, progress);
    if (!descent) return descent;
    q_mm = descent->u_mm;
    descent->u_mm = handles.basis->displacement(q_mm);
    return descent;
  };
  auto lagrangian =
      AugmentedLagrangian::create(handles.body, stations.front(), options, handles.basis->displacement(q_mm));
  if (!lagrangian) return failure(std::move(lagrangian.error()));
  AppliedLoads all = loads;
  const auto equilibrate = [&](const std::vector<ContactTool>& tools) {
    all = lagrangian->with_pulls(loads, tools);
    const ElasticPotential alone(handles.body, handles.materials, all);
    return lagrangian->equilibrate(tools, {alone, alone.scale_mN(), settle});
  };
  bool rested = true;
  const auto station = go_through(stations, equilibrate, rested, progress);
  if (!station) return failure(station.error());
  const Eigen::VectorXd& u_mm = lagrangian->displacement_mm();
  StaticResult state = state_of(handles.body, handles.materials, u_mm, all, lagrangian->force_mN());
  state.fixed_reaction_mN = sum_of(handles.holding_force_mN(u_mm));
  LargeContact contact =
      outcome(*lagrangian, std::move(state), stations[*station - 1], rested, *station, stations.size(), options);
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  return contact;
}

}  // namespace glisson::mechanics
