// Pieces of a surface on the two sides of a cut.

#include "geometry/clip_surface.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <numbers>

#include "support/shapes.h"

namespace glisson::geometry {
namespace {

TEST(ClippedSurface, PiecesOfAPlaneMakeUpTheWholeAndEndOnIt) {
  const Surface sphere = test::sphere_surface(10, 4);
  const CutSurface plane = CutSurface::plane({0, 0, 3}, {0, 0, 1}).value();
  const Surface above = clipped(sphere, plane, CutSide::above), below = clipped(sphere, plane, CutSide::below);
  EXPECT_NEAR(area_mm2(above) + area_mm2(below), area_mm2(sphere), 1e-9 * area_mm2(sphere));
  // A cap of height h has the area 2 pi r h; the sphere of 5120 triangles is a little smaller than the round one.
  EXPECT_NEAR(area_mm2(above), 2 * std::numbers::pi * 10 * 7, 0.005 * 440);
  for (const auto& point : above.points_mm) EXPECT_GE(point.z(), 3 - 1e-12);
  for (const auto& point : below.points_mm) EXPECT_LE(point.z(), 3 + 1e-12);
}

TEST(ClippedSurface, KeepsTheWayTheTrianglesTurn) {
  const Surface sphere = test::sphere_surface(10, 3);
  const Surface above = clipped(sphere, CutSurface::plane({0, 0, 0.1}, {0, 0, 1}).value(), CutSide::above);
  for (const auto& triangle : above.triangles) {
    const auto at = [&](int corner) { return above.points_mm[static_cast<std::size_t>(triangle[corner])]; };
    EXPECT_GE((at(1) - at(0)).cross(at(2) - at(0)).dot(at(0)), -1e-12);
  }
}

TEST(ClippedSurface, ACutThatMissesLeavesAllOnOneSide) {
  const Surface sphere = test::sphere_surface(10, 2);
  const CutSurface plane = CutSurface::plane({0, 0, 30}, {0, 0, 1}).value();
  EXPECT_TRUE(clipped(sphere, plane, CutSide::above).triangles.empty());
  EXPECT_EQ(clipped(sphere, plane, CutSide::below).triangles.size(), sphere.triangles.size());
}

}  // namespace
}  // namespace glisson::geometry
