#pragma once
// Rigid tools and graspers on a meshfree body at large deformation: contact/large_contact.h over affine handles.

#include <vector>

#include "mechanics/contact/large_contact.h"
#include "mechanics/meshfree/meshfree_model.h"

namespace glisson::mechanics {

// What meshfree handles can be touched with. Failure: "not-available" (a grasper whose displacement is given).
Result<void> check_tools_on_meshfree(const std::vector<ContactTool>& tools);

// The same over meshfree handles. Failure besides: that of check_tools_on_meshfree.
Result<LargeContact> find_equilibrium_in_contact(const MeshfreeModel& model, const AppliedLoads& loads,
                                                 const std::vector<std::vector<ContactTool>>& stations,
                                                 const ContactOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::mechanics
