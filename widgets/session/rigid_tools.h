#pragma once
// Tools as the window holds them, and what they are to a session of tools in contact (rehearsal/session.h).

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/tetrahedra.h"
#include "rehearsal/session.h"

namespace glisson::widgets {

enum class Touch { patch, rigid };

struct PlacedTool {
  std::string preset;                   // rehearsal/tool_presets.h
  Eigen::Vector3d center_mm{0, 0, 0};   // on the liver's surface, at rest
  Eigen::Vector3d outward{0, -1, 0};    // unit, of the surface there
  double radius_mm = 0;                 // of the patch that it touches
  Eigen::Vector3d direction{0, -1, 0};  // of the force, unit
  double force_N = 0;

  [[nodiscard]] Eigen::Vector3d pull_N() const { return force_N * direction; }
  // Away from the organ: the tool must hold it. Otherwise it pushes.
  [[nodiscard]] bool pulls() const { return direction.dot(outward) > 0; }
  bool operator==(const PlacedTool&) const = default;
};

// As a patch the force is spread over what it touches. Of rigid ones the grasper holds its patch; the others are solids
// that come from outside along the force until the organ pushes back. They cannot pull: failure "tool-cannot-pull".
Result<mechanics::ContactTool> contact_tool(const PlacedTool& tool, const std::string& id, Touch touch);

// A session's state in the terms of the rehearsal without contact: the force is that of all tools.
[[nodiscard]] rehearsal::RehearsalState state_of(const rehearsal::SessionState& state);

// Each tool where it is now, in patient coordinates; nothing for a grasper or a patch.
[[nodiscard]] std::vector<mechanics::ToolShape> solids_of(const rehearsal::SessionState& state);

}  // namespace glisson::widgets
