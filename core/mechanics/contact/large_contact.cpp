#include "mechanics/contact/large_contact.h"

#include "base/stopwatch.h"
#include "mechanics/contact/internal/tool_stations.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/internal/elastic_potential.h"

namespace glisson::mechanics {

Result<LargeContact> find_equilibrium_in_contact(const Body& body, const std::vector<Material>& materials,
                                                 const AppliedLoads& loads,
                                                 const std::vector<std::vector<ContactTool>>& stations,
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
  auto lagrangian = AugmentedLagrangian::create(body, stations.front(), options, std::move(from_mm), walls);
  if (!lagrangian) return failure(std::move(lagrangian.error()));
  AppliedLoads all = loads;
  std::size_t station_now = 0;
  const auto equilibrate = [&](const std::vector<ContactTool>& tools) {
    AppliedLoads standing_loads = loads;
    if (!walls.empty()) {
      const double part = static_cast<double>(++station_now) / static_cast<double>(stations.size());
      standing_loads.dead_mN *= part;
      standing_loads.follower_pressure_kPa *= part;
    }
    all = lagrangian->with_pulls(std::move(standing_loads), tools);
    const ElasticPotential alone(body, materials, all);
    const auto settle = [&](const Potential& with_tools, double scale_mN, const Eigen::VectorXd& start_mm) {
      return minimise(with_tools, body.resolved.fixed, scale_mN, start_mm,
                      {residual_of_a_round, newton_steps_of_a_round, body.options.memory_limit_bytes}, progress);
    };
    return lagrangian->equilibrate(tools, {alone, alone.scale_mN(), settle});
  };
  bool rested = true;
  const auto station = go_through(stations, equilibrate, rested, progress.part(0.1, 1.0));
  if (!station) return failure(station.error());
  StaticResult state = state_of(body, materials, lagrangian->displacement_mm(), all, lagrangian->force_mN());
  LargeContact contact =
      outcome(*lagrangian, std::move(state), stations[*station - 1], rested, *station, stations.size(), options);
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  return contact;
}

}  // namespace glisson::mechanics
