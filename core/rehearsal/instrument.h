#pragma once
// Instruments as they are drawn: more than their solids in contact (mechanics/scenario/rigid_tool.h), with shaft and
// handle, so that a tool is known by its look. Shapes and sizes are plain ones of ours; nothing is computed with them.

#include <Eigen/Core>
#include <string>

#include "mechanics/scenario/rigid_tool.h"

namespace glisson::rehearsal {

// The instrument of that preset (tool_presets.h; another name: the probe). Its working end is at `touch_mm` (patient
// LPS, mm). Its shaft lies along `into`, the unit direction from the hand to the tissue. Up to `bare_mm` from the end
// the shaft is a thin rod, so that an arrow can be seen around it.
[[nodiscard]] mechanics::ToolShape instrument(const std::string& preset, const Eigen::Vector3d& touch_mm,
                                              const Eigen::Vector3d& into, double bare_mm);

}  // namespace glisson::rehearsal
