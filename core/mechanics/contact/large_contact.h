#pragma once
// Rigid tools that press on a body at large deformation, of any material and with all that is around it. None enters by
// more than a tolerance. Several act at once, with friction or without, held in place or pushed by a force. Graspers
// pull with a force, or hold their patch's mean at a displacement. The counterpart of contact.h, a factorisation a
// Newton step and therefore far from live.
//
// Contacts are at quadrature points of the surface (internal/contact_points.h), each an augmented Lagrangian of the gap
// g to a tool's rod (e.g. Wriggers, Computational Contact Mechanics, 6.3). The term (max(0, p - k g)^2 - p^2) / (2 k)
// joins the body's potential energy (newton.h), k being a stiffness per area times the point's area. The multiplier p
// is updated to max(0, p - k g) until neither the nodes' forces nor the surface change. A uniform pressure is borne
// exactly. Between its points a tool may lie deeper than the tolerance, by 0.2 mm at most.
//
// Coulomb's friction joins in the same way (ibid., 6.3.3; Simo and Laursen 1992, Comput. Struct. 42:97). Its multiplier
// is t, |t| <= mu p; s is the slip since the station before; y = t - k s. While the place sticks, |y| <= mu p, the term
// is |y|^2 / (2 k). While it slips, it is (mu p |y| - (mu p)^2 / 2) / k. The values of p, mu p and the normal are of
// the round before.
//
// Jaws that prescribe a displacement are the term (|p - k d|^2 - |p|^2) / (2 k), d being how far their patch is off.
// The advance of a pushed tool is found by secants on the force that it meets.

#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {

struct LargeContact {
  StaticResult result;  // of the last station that was reached; `iterations` are Newton steps
  std::vector<ToolContact> tools;
  ContactReport report;
};

// The tools go through the stations, one set of the same tools after the other. Between two none should move by more
// than half its rods' radius. The result did not converge where a station was not reached, and `why_stopped` says
// which. Failures: those of find_equilibrium; "tool-invalid", "tool-touches-nothing".
//
// `walls`, those of a body's cuts, slide along each other without passing through by more than the tolerance. The same
// springs act between each of their points and the triangle across from it. The way begins at rest then, with the loads
// growing from station to station.
Result<LargeContact> find_equilibrium_in_contact(const Body& body, const std::vector<Material>& materials,
                                                 const AppliedLoads& loads,
                                                 const std::vector<std::vector<ContactTool>>& stations,
                                                 const ContactOptions& options = {}, const Progress& progress = {},
                                                 const std::vector<OpenedBody::Wall>& walls = {});

}  // namespace glisson::mechanics
