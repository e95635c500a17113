// A place on a picture taken to space: on a slanted, curved surface through a lens that bends, beside a hole and at a
// step in depth.

#include "guidance/seen_line.h"

#include <gtest/gtest.h>
#include <random>

#include "vision/draw.h"

namespace glisson::guidance {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

vision::Camera lens() {
  vision::Camera camera;
  camera.matrix << 600, 0, 320, 0, 600, 240, 0, 0, 1;
  camera.distortion = {-0.2, 0.05, 0.001, -0.002, 0};
  return camera;
}

// A bowl, tilted by a third.
double depth_mm(double x_mm, double y_mm) { return 120 + 0.3 * x_mm + 0.004 * (x_mm * x_mm + y_mm * y_mm); }

std::vector<Vector3d> cloud() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> across(-45, 45);
  std::vector<Vector3d> points;
  while (points.size() < 3000) {
    const double x_mm = across(random), y_mm = across(random);
    if (std::hypot(x_mm - 20, y_mm) < 12) continue;  // an instrument
    points.emplace_back(x_mm, y_mm, depth_mm(x_mm, y_mm));
  }
  return points;
}

Vector2d pixel_of(const Vector3d& place_mm) { return vision::project(lens(), {place_mm}).front().value(); }

TEST(SeenLine, APlaceOnThePictureLiesOnTheSurfaceThatWasSeen) {
  const auto points = cloud();
  for (const Vector2d& at : {Vector2d(-30, 10), Vector2d(0, 0), Vector2d(-12, -33), Vector2d(5, 27)}) {
    const Vector3d truly(at.x(), at.y(), depth_mm(at.x(), at.y()));
    const auto found = on_seen_surface(lens(), points, pixel_of(truly));
    ASSERT_TRUE(found);
    EXPECT_LT((*found - truly).norm(), 0.1);
  }
}

TEST(SeenLine, BehindAnInstrumentNothingWasSeen) {
  EXPECT_FALSE(on_seen_surface(lens(), cloud(), pixel_of({20, 0, depth_mm(20, 0)})));
  EXPECT_FALSE(on_seen_surface(lens(), {}, {320, 240}));
}

TEST(SeenLine, ASurfaceBehindAStepDoesNotDrawThePlaceAway) {
  std::vector<Vector3d> points;
  for (int i = -30; i <= 30; ++i) {
    for (int j = -30; j <= 30; ++j) points.emplace_back(i, j, i <= 0 ? 100 : 140);
  }
  const auto found = on_seen_surface(lens(), points, pixel_of({-0.3, 2, 100}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->z(), 100, 0.5);
}

TEST(SeenLine, IsFilledInBetweenItsPlaces) {
  const auto filled = filled_in({{0, 0, 0}, {10, 0, 0}, {10, 1, 0}}, 3);
  ASSERT_EQ(filled.size(), 6u);
  EXPECT_EQ(filled.front(), Vector3d(0, 0, 0));
  EXPECT_EQ(filled[4], Vector3d(10, 0, 0));
  EXPECT_EQ(filled.back(), Vector3d(10, 1, 0));
  for (std::size_t p = 1; p < filled.size(); ++p) EXPECT_LE((filled[p] - filled[p - 1]).norm(), 3);
  EXPECT_EQ(filled_in({{1, 2, 3}}, 3).size(), 1u);
  EXPECT_TRUE(filled_in({}, 3).empty());
}

}  // namespace
}  // namespace glisson::guidance
