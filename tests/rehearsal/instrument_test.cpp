// Instruments as drawn: they touch where the tool touches, and the hand is on the other side.

#include "rehearsal/instrument.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "rehearsal/tool_presets.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

double farthest_into(const mechanics::ToolShape& shape, const Vector3d& from_mm, const Vector3d& into) {
  double farthest = -1e9;
  for (const mechanics::Rod& rod : shape) {
    for (const Vector3d& end : {rod.from_mm, rod.to_mm})
      farthest = std::max(farthest, (end - from_mm).dot(into) + rod.radius_mm);
  }
  return farthest;
}

TEST(Instrument, touches_the_tissue_and_does_not_pass_through_it) {
  const Vector3d touch_mm(12, -40, 7);
  for (const ToolPreset& preset : tool_presets()) {
    for (const Vector3d& into :
         {Vector3d(0, 0, 1), Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(1, -1, 2).normalized()}) {
      const auto shape = instrument(preset.id, touch_mm, into, 30);
      EXPECT_NEAR(farthest_into(shape, touch_mm, into), 0, 1e-9) << preset.id;
      EXPECT_GT(farthest_into(shape, touch_mm, -into), 120) << preset.id;  // shaft and handle, towards the hand
      EXPECT_TRUE(mechanics::check_tool(shape, {}).has_value()) << preset.id;
    }
  }
}

TEST(Instrument, leaves_the_shaft_thin_where_an_arrow_stands) {
  for (const char* preset : {"grasper", "palpation-probe"}) {
    const auto shape = instrument(preset, {0, 0, 0}, {0, 0, 1}, 60);
    for (const mechanics::Rod& rod : shape) {
      const bool beside_the_arrow = rod.from_mm.z() < -25 && rod.from_mm.z() > -59;
      EXPECT_TRUE(!beside_the_arrow || rod.radius_mm < 1.6) << preset;
    }
  }
}

TEST(Instrument, looks_different_for_each_tool) {
  EXPECT_EQ(instrument("palpation-probe", {0, 0, 0}, {0, 0, 1}, 30).size(), 4u);
  EXPECT_EQ(instrument("grasper", {0, 0, 0}, {0, 0, 1}, 30).size(), 8u);
  EXPECT_EQ(instrument("nathanson-retractor", {0, 0, 0}, {0, 0, 1}, 30).size(), 10u);
}

TEST(Instrument, comes_from_the_patients_front) {
  const auto shape = instrument("nathanson-retractor", {0, 0, 0}, {0, 0, 1}, 30);
  EXPECT_LT(shape.back().to_mm.y(), -60);
}

}  // namespace
}  // namespace glisson::rehearsal
