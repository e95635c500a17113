#include "rehearsal/instrument.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ToolShape;

constexpr double shaft_mm = 2.5;  // radii
constexpr double thin_mm = 1.1;
constexpr double handle_mm = 4.5;
constexpr double shaft_length_mm = 110;
constexpr double handle_length_mm = 45;

// All in the tool's own frame, +z into the tissue, the end at the origin.
void add_shaft(ToolShape& shape, const Vector3d& from_mm, double bare_mm) {
  const Vector3d thick_mm(0, 0, std::min(from_mm.z(), -bare_mm));
  const Vector3d grip_mm = thick_mm - Vector3d(0, 0, shaft_length_mm);
  shape.push_back({from_mm, thick_mm, thin_mm});
  shape.push_back({thick_mm, grip_mm, shaft_mm});
  shape.push_back({grip_mm, grip_mm - Vector3d(0, 0, handle_length_mm), handle_mm});
}

ToolShape probe(double bare_mm) {
  ToolShape shape = mechanics::palpation_probe();
  const double radius_mm = shape.front().radius_mm;
  shape.front().from_mm.z() = shape.front().to_mm.z() = -radius_mm;
  add_shaft(shape, {0, 0, -radius_mm}, bare_mm);
  return shape;
}

// Two bent jaws that meet at the tip.
ToolShape grasper(double bare_mm) {
  constexpr double jaw_mm = 1.5;
  const Vector3d hinge_mm(0, 0, -20);
  ToolShape shape;
  for (const double side : {-1.0, 1.0}) {
    const Vector3d bend_mm(4.2 * side, 0, -9), tip_mm(1.4 * side, 0, -jaw_mm);
    shape.push_back({hinge_mm, bend_mm, jaw_mm});
    shape.push_back({bend_mm, tip_mm, jaw_mm});
  }
  shape.push_back({hinge_mm, hinge_mm, shaft_mm});
  add_shaft(shape, hinge_mm, bare_mm);
  return shape;
}

// The blade lies flat against the organ; its rod leaves it sideways, then turns away.
ToolShape retractor() {
  ToolShape shape = mechanics::nathanson_retractor();
  const double rod_mm = shape.front().radius_mm;
  for (mechanics::Rod& rod : shape) rod.from_mm.z() = rod.to_mm.z() = -rod_mm;
  const Vector3d left_mm = shape.front().from_mm, right_mm = shape.back().to_mm;
  const Vector3d joint_mm(0, left_mm.y() - 22, -rod_mm), elbow_mm(0, left_mm.y() - 48, -26);
  const Vector3d end_mm = elbow_mm - Vector3d(0, 20, shaft_length_mm);
  shape.push_back({left_mm, joint_mm, rod_mm});
  shape.push_back({right_mm, joint_mm, rod_mm});
  shape.push_back({joint_mm, elbow_mm, rod_mm});
  shape.push_back({elbow_mm, end_mm, rod_mm});
  shape.push_back({end_mm, end_mm + handle_length_mm * (end_mm - elbow_mm).normalized(), handle_mm});
  return shape;
}

// The hand's side (-y) as far to the patient's front as can be, else to the feet: where the ports are.
mechanics::Pose pose_at(const Vector3d& touch_mm, const Vector3d& into) {
  const Vector3d to_front(0, -1, 0), to_feet(0, 0, -1);
  const Vector3d wanted = std::abs(into.y()) < 0.95 ? to_front : to_feet;
  const Vector3d from_hand = -(wanted - wanted.dot(into) * into).normalized();
  mechanics::Pose pose;
  pose.position_mm = touch_mm;
  pose.rotation << from_hand.cross(into), from_hand, into;
  return pose;
}

}  // namespace

ToolShape instrument(const std::string& preset, const Vector3d& touch_mm, const Vector3d& into, double bare_mm) {
  const ToolShape shape = preset == "grasper"               ? grasper(bare_mm)
                          : preset == "nathanson-retractor" ? retractor()
                                                            : probe(bare_mm);
  return mechanics::placed(shape, pose_at(touch_mm, into.normalized()));
}

}  // namespace glisson::rehearsal
