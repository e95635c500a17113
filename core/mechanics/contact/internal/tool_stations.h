#pragma once
// The way of tools from station to station, and what stands at its end: what finite elements and the meshfree engine
// share (large_contact.h).

#include <vector>

#include "mechanics/contact/internal/augmented_lagrangian.h"
#include "mechanics/contact/large_contact.h"

namespace glisson::mechanics {

// Through the stations, up to one where no rest is found, over any unknowns. `materials` are the body's; `from_mm` are
// the unknowns at the beginning. With walls the loads grow from station to station. Failures: those of
// find_equilibrium_in_contact.
Result<LargeContact> go_through(const std::vector<std::vector<ContactTool>>& stations, const Unknowns& unknowns,
                                const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                                const ContactOptions& options, Eigen::VectorXd from_mm,
                                const std::vector<OpenedBody::Wall>& walls, const Progress& progress);

}  // namespace glisson::mechanics
