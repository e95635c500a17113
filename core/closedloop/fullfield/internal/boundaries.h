#pragma once
// Which points of a plane are a boundary whose name a table or an experiment gives, and in which directions the machine
// moves them.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "closedloop/experiment/experiment.h"
#include "geometry/surface.h"

namespace glisson::closedloop {

struct ReactionRow {
  std::string boundary;
  Eigen::Vector2d force;  // not a number where it is not given
  std::string where;      // for refusals
};
struct PrescribedRow {
  std::string boundary;
  Eigen::Vector2d displacement;
  std::string where;
};

// Sets `field.boundaries`, and of each trial `prescribed` and `reaction`. A name is looked for, in this order, among
//   - the experiment's "boundaries": {"grip": {"point_array": "fixed", "value": 2, "prescribed": ["x"]}};
//   - the mesh's point arrays: points that are not 0 in the array of that name;
//   - its arrays "group_x" and "group_y": the number in the name is the group's ("2", "x2", "F2_x"), whose displacement
//     is prescribed in x or in y;
//   - the sides of the box around the mesh: left, right, bottom, top, also x_min, x0, ...; along the normal, and across
//     it where the reaction says so.
// Boundaries without a name are the other groups of those arrays; where there are none, sides that moved as one.
// Refused (experiment-invalid): a name without points, a reaction where nothing is prescribed, no reaction at all.
void assign_boundaries(const Json& declared, const geometry::Surface& mesh,
                       const std::vector<std::vector<ReactionRow>>& reactions,
                       const std::vector<std::vector<PrescribedRow>>& prescribed, FullField& field);

// How the points of a boundary that were measured moved along an axis in a trial.
struct BoundaryMove {
  double count = 0;  // of points measured
  double mean = 0;
  double spread = 0;  // standard deviation, of all of them
};
[[nodiscard]] BoundaryMove boundary_move(const PlaneTrial& trial, int axis, const std::vector<int>& points);

}  // namespace glisson::closedloop
