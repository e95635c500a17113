#include "widgets/views/tool_in_view.h"

#include <algorithm>

#include "rehearsal/instrument.h"

namespace glisson::widgets {
namespace {

constexpr double shortest_arrow_mm = 18;
constexpr double arrow_mm_per_N = 7;

}  // namespace

double arrow_length_mm(double force_N) { return shortest_arrow_mm + arrow_mm_per_N * force_N; }
double arrow_force_N(double length_mm) { return std::max(0.0, (length_mm - shortest_arrow_mm) / arrow_mm_per_N); }

mechanics::ToolShape drawn_tool(const ToolInView& tool, const Eigen::Vector3d& at_mm) {
  const Eigen::Vector3d into = tool.pulls ? Eigen::Vector3d(-tool.direction) : tool.direction;
  const double bare_mm = arrow_length_mm(tool.force_N);
  if (tool.rods.empty()) return rehearsal::instrument(tool.preset, at_mm, into, bare_mm);
  if (tool.rods.size() > 1) return tool.rods;
  const mechanics::Rod& ball = tool.rods.front();
  mechanics::ToolShape shape = rehearsal::instrument(tool.preset, ball.to_mm + ball.radius_mm * into, into, bare_mm);
  shape.front() = ball;
  return shape;
}

}  // namespace glisson::widgets
