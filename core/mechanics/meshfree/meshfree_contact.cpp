#include "mechanics/meshfree/meshfree_contact.h"

#include "mechanics/contact/internal/tool_stations.h"
#include "mechanics/meshfree/internal/reduced_potential.h"
#include "mechanics/statics/displacements.h"

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
  const MeshfreeBody& handles = model.body();
  if (auto checked = check_tools_on_meshfree(stations.front()); !checked) return failure(std::move(checked.error()));
  const HandleUnknowns unknowns(handles);
  auto contact =
      go_through(stations, unknowns, handles.body, handles.materials, loads, options, unknowns.at_rest(), {}, progress);
  if (!contact) return contact;
  const Eigen::VectorXd u_mm = nodal_displacements(handles.body.layout, contact->result);
  contact->result.fixed_reaction_mN = sum_of(handles.penalty_force_mN(u_mm));
  return contact;
}

}  // namespace glisson::mechanics
