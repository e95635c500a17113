#include "widgets/session/rigid_tools.h"

#include <algorithm>
#include <Eigen/Geometry>

#include "base/units.h"

namespace glisson::widgets {
namespace {

// Far enough off the surface that the tool's solid touches nothing yet.
constexpr double probe_gap_mm = 2;
constexpr double blade_gap_mm = 12;  // the blade is flat, the organ is not

}  // namespace

Result<mechanics::ContactTool> contact_tool(const PlacedTool& tool, const std::string& id, Touch touch) {
  const double force_mN = units::mN_from_N(tool.force_N);
  if (touch == Touch::patch) {
    return mechanics::ContactTool{id, mechanics::ToolLoad{tool.center_mm, tool.radius_mm, force_mN * tool.direction}};
  }
  if (tool.preset == "grasper") {
    return mechanics::ContactTool{id, mechanics::Grasp{tool.center_mm, tool.radius_mm, force_mN, tool.direction}};
  }
  if (tool.pulls()) {
    return failure(Error{"tool-cannot-pull",
                         GLISSON_TEXT("A rigid tool that only touches the liver cannot pull it."),
                         {},
                         GLISSON_TEXT("Push into the surface, or take the grasper."),
                         {}});
  }
  const bool probe = tool.preset == "palpation-probe";
  const double gap_mm = probe ? tool.radius_mm + probe_gap_mm : blade_gap_mm;
  return mechanics::ContactTool{
      id, mechanics::TouchingTool{probe ? mechanics::palpation_probe(tool.radius_mm) : mechanics::nathanson_retractor(),
                                  mechanics::pose_towards(tool.center_mm - gap_mm * tool.direction, tool.direction),
                                  force_mN}};
}

rehearsal::RehearsalState state_of(const rehearsal::SessionState& session) {
  rehearsal::RehearsalState state;
  for (const auto& tool : session.patient_step.tools) state.force_N += 1e-3 * tool.force_mN;
  state.patient = session.patient;
  state.reference = session.reference;
  state.differences = session.differences;
  state.max_difference_mm = session.max_difference_mm;
  state.relative_residual = session.patient_step.report.relative_residual;
  if (session.reference_step) {
    state.relative_residual = std::max(state.relative_residual, session.reference_step->report.relative_residual);
  }
  state.validity = session.validity;
  state.answer_ms = session.step_ms;
  state.cut = session.cut;
  return state;
}

std::vector<mechanics::ToolShape> solids_of(const rehearsal::SessionState& state) {
  std::vector<mechanics::ToolShape> solids;
  for (const mechanics::ContactTool& tool : state.tools) {
    mechanics::ToolShape& solid = solids.emplace_back();
    const auto* touching = std::get_if<mechanics::TouchingTool>(&tool.what);
    if (touching == nullptr) continue;
    mechanics::Pose pose = touching->pose;
    for (const mechanics::ToolContact& contact : state.patient_step.tools) {
      if (contact.id == tool.id) pose = pose.advanced(contact.advance_mm);
    }
    solid = mechanics::placed(touching->shape, pose);
  }
  return solids;
}

}  // namespace glisson::widgets
