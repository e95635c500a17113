#pragma once
// The unknown forces of a linear body in contact, one a column of a small dense problem (contact_forces.h): where tools
// touch, where walls of a cut meet, and what jaws hold at a displacement. Inside of this room.

#include <set>

#include "mechanics/contact/internal/contact_candidates.h"
#include "mechanics/contact/internal/contact_forces.h"
#include "mechanics/contact/internal/cut_self_contact.h"
#include "mechanics/contact/internal/surface_responses.h"

namespace glisson::mechanics {

// Forces on points of the surface (mN) for 1 mN of an unknown one, and what keeps the two apart where it begins.
struct ContactColumn {
  std::vector<std::pair<int, Eigen::Vector3d>> on;
  double start_mm = 0;                   // without any of the unknown forces and without advances
  std::optional<std::size_t> pushed_by;  // a tool on a slide
  double along = 0;                      // of that tool's way, in the gap
  int wall = -1;                         // of a live cut, whose sides the force pushes apart
};

// Of the places, of the walls' meetings, of a live cut's walls, of what jaws hold at a displacement: in this order.
struct ContactColumns {
  std::vector<ContactColumn> all;
  std::size_t places = 0, meetings = 0;
  int two_sided = 0;
  PointForces given_mN;  // by graspers that pull
};

// What touches now, on a surface moved by surface_mm (3 a point) by tools that slid by advance_mm (one a tool).
struct Touching {
  const std::vector<ContactTool>& tools;
  const std::vector<ContactCandidate>& places;
  const std::vector<Gripped>& grips;
  const std::vector<CutContact>& meetings;
  const std::set<int>& live_walls;
  const Eigen::VectorXd& advance_mm;
  const Eigen::VectorXd& surface_mm;
};

// The answers to forces at the places must be remembered. Failures: those of SurfaceResponses::surface_under.
[[nodiscard]] Result<ContactColumns> columns_of(const SurfaceResponses& responses, const Touching& touching);

[[nodiscard]] ContactProblem problem_of(const SurfaceResponses& responses, const std::vector<ContactTool>& tools,
                                        const ContactColumns& columns);

// The tool where a known force pushes it along a slide; else nullptr.
[[nodiscard]] const TouchingTool* pushed(const ContactTool& tool);

}  // namespace glisson::mechanics
