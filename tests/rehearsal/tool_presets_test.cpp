// Tools, and where the retractor goes.

#include "rehearsal/tool_presets.h"

#include <gmock/gmock.h>

#include "mechanics/bodies.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

// An ellipsoid of a liver's size, its cube-shaped grid pulled onto a ball; LPS.
geometry::TetMesh ellipsoid(const Vector3d& center_mm, const Vector3d& half_axes_mm) {
  return mechanics::test::bent_box(8, 8, 8, [&](const Vector3d& unit) {
    const Vector3d p = 2 * unit - Vector3d(1, 1, 1);
    const double largest = p.cwiseAbs().maxCoeff();
    const Vector3d on_ball = largest > 0 ? Vector3d(p * largest / p.norm()) : p;
    return Vector3d(center_mm + on_ball.cwiseProduct(half_axes_mm));
  });
}

TEST(ToolPresets, EachSaysWhereItsFiguresComeFrom) {
  for (const ToolPreset& preset : tool_presets()) {
    EXPECT_FALSE(preset.source.empty()) << preset.id;
    EXPECT_GT(preset.radius_mm, 0);
    EXPECT_LE(preset.usual_force_N, preset.largest_force_N);
    EXPECT_EQ(tool_preset(preset.id)->name, preset.name);
  }
  EXPECT_THAT(tool_preset("spoon").error().advice(), testing::HasSubstr("nathanson-retractor"));
}

TEST(HoistSegmentVi, GoesToTheRightRearUndersideAndLiftsForwardAndUp) {
  const Vector3d center_mm(-60, 20, 900);
  const auto placement = hoist_segment_vi(ellipsoid(center_mm, {100, 70, 80})).value();
  const Vector3d from_center = placement.center_mm - center_mm;
  EXPECT_LT(from_center.x(), -20);  // the patient's right is -x in LPS
  EXPECT_GT(from_center.y(), 15);   // the back is +y
  EXPECT_LT(from_center.z(), -15);  // the feet are -z
  EXPECT_NEAR(placement.direction.norm(), 1.0, 1e-12);
  EXPECT_LT(placement.direction.y(), 0);
  EXPECT_GT(placement.direction.z(), 0);
  const mechanics::ToolLoad load = tool_load(placement, 5.0);
  EXPECT_NEAR(load.force_mN.norm(), 5000.0, 1e-9);  // 5 N
  EXPECT_EQ(load.radius_mm, placement.preset.radius_mm);
}

TEST(HoistSegmentVi, DoesNotDependOnWhereThePatientLies) {
  const auto here = hoist_segment_vi(ellipsoid({0, 0, 0}, {100, 70, 80})).value();
  const auto there = hoist_segment_vi(ellipsoid({500, -300, 1200}, {100, 70, 80})).value();
  EXPECT_LT((there.center_mm - here.center_mm - Vector3d(500, -300, 1200)).norm(), 1e-6);
}

TEST(HoistSegmentVi, RefusesAnEmptyBody) { EXPECT_FALSE(hoist_segment_vi({})); }

}  // namespace
}  // namespace glisson::rehearsal
