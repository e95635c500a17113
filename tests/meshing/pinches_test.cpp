// Bodies that touch themselves in a point or an edge.

#include "meshing/internal/pinches.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace glisson::meshing {
namespace {

using geometry::TetMesh;

// Two boxes of bricks in one mesh; points at the same place are one point.
TetMesh joined(const TetMesh& a, const TetMesh& b) {
  TetMesh both = a;
  std::vector<int> number;
  for (const auto& point : b.points_mm) {
    int found = -1;
    for (std::size_t i = 0; i < a.points_mm.size(); ++i) {
      if ((a.points_mm[i] - point).norm() < 1e-9) found = static_cast<int>(i);
    }
    if (found < 0) {
      found = static_cast<int>(both.points_mm.size());
      both.points_mm.push_back(point);
    }
    number.push_back(found);
  }
  for (auto cell : b.cells) {
    for (int& corner : cell) corner = number[static_cast<std::size_t>(corner)];
    both.cells.push_back(cell);
  }
  return both;
}

TEST(Pinches, ASoundBodyIsLeftAlone) {
  TetMesh box = test::box_of_tetrahedra({3, 3, 3}, {1, 1, 1});
  EXPECT_EQ(remove_pinches(box), 0U);
  EXPECT_EQ(box.cells.size(), 27U * 6);
}

TEST(Pinches, OfTwoBodiesThatShareAPointTheLargerStays) {
  const TetMesh large = test::box_of_tetrahedra({2, 2, 2}, {1, 1, 1});
  TetMesh both = joined(large, test::box_of_tetrahedra({1, 1, 1}, {0.5, 0.5, 0.5}, {1, 1, 1}));
  EXPECT_EQ(remove_pinches(both), 6U);
  EXPECT_EQ(both.cells, large.cells);
}

TEST(Pinches, ARingThatClosesOnAnEdgeIsOpenedThere) {
  // Bricks round a hole, of which the first and the last share an edge only: the body hangs together by faces, and its
  // surface is no manifold until the cells of one side of the edge have gone.
  const auto brick = [](double x, double y, double z) {
    return test::box_of_tetrahedra({1, 1, 1}, {1, 1, 1}, {x, y, z});
  };
  TetMesh ring = brick(0, 0, 0);
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, 1), {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {1, 1, 1}, {1, 1, 0}}) {
    ring = joined(ring, brick(at.x(), at.y(), at.z()));
  }
  ASSERT_TRUE(check_tetrahedra(ring));
  ASSERT_FALSE(pinched_points(boundary_surface(ring)).empty());
  const std::size_t before = ring.cells.size();
  const std::size_t removed = remove_pinches(ring);
  EXPECT_GT(removed, 0U);
  EXPECT_LT(removed, before / 2);
  EXPECT_TRUE(check_tetrahedra(ring));
  EXPECT_TRUE(is_watertight(boundary_surface(ring)));
  EXPECT_TRUE(pinched_points(boundary_surface(ring)).empty());
}

}  // namespace
}  // namespace glisson::meshing
