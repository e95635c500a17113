#include "mechanics/contact/large_contact.h"

#include "mechanics/contact/internal/tool_stations.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

Result<LargeContact> find_equilibrium_in_contact(const Body& body, const std::vector<Material>& materials,
                                                 const AppliedLoads& loads,
                                                 const std::vector<std::vector<ContactTool>>& stations,
                                                 const ContactOptions& options, const Progress& progress,
                                                 const std::vector<OpenedBody::Wall>& walls) {
  const NodalUnknowns unknowns(body);
  Eigen::VectorXd from_mm = unknowns.at_rest();
  if (walls.empty()) {
    auto standing = find_equilibrium(body, materials, loads, {}, progress.part(0.0, 0.1));
    if (!standing) return failure(std::move(standing.error()));
    if (!standing->converged()) return LargeContact{std::move(*standing), {}, {}};
    from_mm = nodal_displacements(body.layout, *standing);
  }
  return go_through(stations, unknowns, body, materials, loads, options, std::move(from_mm), walls,
                    progress.part(0.1, 1.0));
}

}  // namespace glisson::mechanics
