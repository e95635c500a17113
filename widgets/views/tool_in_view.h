#pragma once
// A tool as the view in space shows it: the instrument, and the arrow of its force that a hand can drag.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mechanics/scenario/rigid_tool.h"

namespace glisson::widgets {

struct ToolInView {
  Eigen::Vector3d center_mm{0, 0, 0};  // on the liver at rest
  Eigen::Vector3d direction{0, -1, 0};
  double force_N = 0;
  bool pulls = false;                // the arrow leaves the liver there; otherwise it ends there
  std::vector<mechanics::Rod> rods;  // the solid tool, where it is now; none where it is but a patch
  std::string preset;                // which instrument is drawn there (rehearsal/tool_presets.h)
};

// The arrow is longer the larger the force: 18 mm and 7 mm more a newton, whatever the zoom.
[[nodiscard]] double arrow_length_mm(double force_N);
[[nodiscard]] double arrow_force_N(double length_mm);

// What is drawn of it where the tissue under it is now: the solid in contact where there is one, with its instrument.
[[nodiscard]] mechanics::ToolShape drawn_tool(const ToolInView& tool, const Eigen::Vector3d& at_mm);

}  // namespace glisson::widgets
