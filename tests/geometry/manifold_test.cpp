#include "geometry/manifold.h"

#include <gtest/gtest.h>

#include "geometry/geodesic.h"

namespace glisson::geometry {
namespace {

// Two squares of two triangles that touch in point 3, a third triangle on the edge 0-2, and a triangle far away.
Surface mess() {
  Surface surface;
  surface.points_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 3, 0},
                       {2, 3, 0}, {0, 0, 1}, {9, 9, 9}, {9, 9, 8}, {9, 8, 9}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 5}, {4, 6, 5}, {1, 2, 7}, {8, 9, 10}};
  std::vector<double> values;
  for (int i = 0; i < 11; ++i) values.push_back(i);
  surface.point_fields = {{"number", 1, values}};
  return surface;
}

TEST(Manifold, KeepsTheLargestPieceThatHangsTogetherByEdges) {
  const Surface piece = largest_manifold_piece(mess());
  EXPECT_EQ(piece.triangles.size(), 2u);
  EXPECT_EQ(piece.point_fields[0].values, (std::vector<double>{3, 4, 5, 6}));  // the larger square
  EXPECT_NEAR(area_mm2(piece), 2, 1e-12);
}

// Two fans in one point, which hang together by edges elsewhere: the point becomes two.
TEST(Manifold, PartsFansThatMeetInAPoint) {
  Surface ring;
  ring.points_mm = {{0, 0, 0}, {2, -1, 0}, {1, 1, 0}, {3, 2, 0}, {1, 3, 1}, {0, 4, 2}};
  ring.triangles = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 0}, {1, 2, 0}};  // the last: edges' third
  const Surface piece = largest_manifold_piece(ring);
  EXPECT_EQ(piece.triangles.size(), 5u);
  EXPECT_EQ(piece.points_mm.size(), 7u);
  EXPECT_EQ(piece.points_mm[0], piece.points_mm[1]);
  EXPECT_TRUE(HeatGeodesics::prepare(piece).has_value());
}

}  // namespace
}  // namespace glisson::geometry
