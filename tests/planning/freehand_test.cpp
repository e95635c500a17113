// A line drawn over a ball, as an eye sees it: the sheet parts the ball along that line of sight.

#include "planning/freehand.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>

#include "geometry/cut_surface.h"
#include "support/shapes.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;
using geometry::CutSurface;

constexpr double radius_mm = 50;
const Vector3d eye_mm(0, -400, 0);

geometry::Surface ball_surface() { return test::sphere_surface(radius_mm, 4); }

// What the eye sees at those places of the plane through the ball's middle, across its sight.
std::vector<SightLine> seen_at(const std::vector<Eigen::Vector2d>& places_mm) {
  std::vector<SightLine> line;
  for (const Eigen::Vector2d& at : places_mm) {
    const Vector3d place_mm(at.x(), 0, at.y());
    line.push_back({place_mm, place_mm - eye_mm});
  }
  return line;
}

TEST(Freehand, AStraightLineIsThePlaneThroughEyeAndLine) {
  // From beside the ball to beside it, as a hand draws: with few places where it was fast.
  const auto cut = sheet_under(ball_surface(),
                               seen_at({{12, 80}, {12, 30}, {12, 25}, {12, 24.99}, {12, -30}, {12, -49}, {12, -80}}));
  ASSERT_TRUE(cut) << cut.error().message();
  EXPECT_GE(cut->through_mm.size(), 8u);
  const auto sheet = CutSurface::through(cut->through_mm);
  ASSERT_TRUE(sheet);
  const Vector3d normal = (Vector3d(12, 0, 30) - eye_mm).cross(Vector3d(0, 0, 1)).normalized();
  EXPECT_GT(std::abs(sheet->normal().dot(normal)), 1 - 1e-6);
  for (const double y : {-45.0, 0.0, 45.0}) {
    for (const double z : {-20.0, 0.0, 20.0}) {
      const Vector3d place_mm(12 * (y + 400) / 400, y, z);  // on that plane
      EXPECT_NEAR(sheet->height_mm(place_mm), 0, 1e-6) << y << ", " << z;
      EXPECT_NEAR(std::abs(sheet->height_mm(place_mm + 7 * normal)), 7, 1e-6);
    }
  }
}

// All that the eye sees on the line is on the sheet, at the front, in the middle and at the back.
TEST(Freehand, ABentLineIsFollowedInDepth) {
  std::vector<Eigen::Vector2d> places_mm;
  const auto bend_mm = [](double z) { return 10 * std::sin(z / 20); };
  for (int z = -60; z <= 60; ++z) places_mm.emplace_back(bend_mm(z), z);
  const auto cut = sheet_under(ball_surface(), seen_at(places_mm));
  ASSERT_TRUE(cut) << cut.error().message();
  const auto sheet = CutSurface::through(cut->through_mm);
  ASSERT_TRUE(sheet);
  for (const double z : {-30.0, -12.0, 0.0, 17.0, 30.0}) {
    const Vector3d middle_mm(bend_mm(z), 0, z);
    for (const double depth : {-0.08, 0.0, 0.08}) {  // of the eye's distance of 400 mm: within the ball
      const Vector3d place_mm = middle_mm + depth * (middle_mm - eye_mm);
      EXPECT_NEAR(sheet->height_mm(place_mm), 0, 1.5) << z << ", " << depth;  // places are 10 mm apart
    }
  }
}

TEST(Freehand, SaysWhatIsNoCut) {
  const auto refused = [](const std::vector<Eigen::Vector2d>& places_mm) {
    const auto cut = sheet_under(ball_surface(), seen_at(places_mm));
    return cut ? std::string() : cut.error().code;
  };
  EXPECT_EQ(refused({}), "line-misses");
  EXPECT_EQ(refused({{0, 0}}), "line-misses");
  EXPECT_EQ(refused({{80, -80}, {80, 80}}), "line-misses");
  EXPECT_EQ(refused({{0, -4}, {0, 4}}), "line-misses");
  EXPECT_EQ(refused({{-30, 0}, {30, 0}, {30, 10}, {-30, 10}, {-30, 20}}), "line-turns-back");
  EXPECT_EQ(refused({{-30, 0}, {30, 0}}), "");
}

}  // namespace
}  // namespace glisson::planning
