// Territories against brute force: every voxel of a convex organ with every point of every branch.

#include <gmock/gmock.h>
#include <cmath>

#include "vasculature/territories.h"
#include "vessels_in_a_ball.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

VesselTrees some_trees() {
  VesselTrees trees;
  trees.branches.push_back(straight(System::portal_vein, -1, {0, 0, -30}, {0, 0, 0}, 4));
  trees.branches.push_back(straight(System::portal_vein, 0, {0, 0, 0}, {25, 5, 15}, 3));
  trees.branches.push_back(straight(System::portal_vein, 0, {0, 0, 0}, {-25, -5, 10}, 1.5));
  trees.branches.push_back(straight(System::hepatic_vein, -1, {0, 20, 20}, {0, -20, 0}, 3));
  return trees;
}

TEST(Territories, AreThoseOfBruteForce) {
  const Mask liver = ball();
  const VesselTrees trees = some_trees();
  const auto territories = territories_of(trees, System::portal_vein, liver);
  ASSERT_TRUE(territories) << territories.error().message();
  double voxels = 0, same = 0, clear = 0, clear_and_same = 0, worst_mm = 0;
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        const std::size_t voxel = liver.grid.offset(i, j, k);
        if (liver.values[voxel] == 0) {
          EXPECT_EQ(territories->branch[voxel], -1);
          continue;
        }
        int nearest = -1;
        double least = 1e30, next = 1e30;
        for (int b = 0; b < 3; ++b) {
          double own = 1e30;
          for (const CenterPoint& point : trees.branches[static_cast<std::size_t>(b)].points) {
            const double beyond = (liver.grid.position_mm(i, j, k) - point.position_mm).norm() - point.radius_mm;
            own = std::min(own, beyond);
          }
          next = std::min(next, std::max(own, least));
          if (own < least) {
            least = own;
            nearest = b;
          }
        }
        ++voxels;
        if (territories->branch[voxel] == nearest) ++same;
        if (next - least > 2) {
          ++clear;
          if (territories->branch[voxel] == nearest) ++clear_and_same;
        }
        if (least > 1) worst_mm = std::max(worst_mm, std::abs(territories->distance_mm[voxel] - least));
      }
    }
  }
  // First-order fronts are a little slow along diagonals: borders lie within a millimetre or two of the true ones.
  EXPECT_GT(same / voxels, 0.95);
  EXPECT_GT(clear / voxels, 0.7);
  EXPECT_GT(clear_and_same / clear, 0.995);
  EXPECT_LT(worst_mm, 2.0);
}

TEST(Territories, AddUpToTheLiverAndABranchHoldsWhatGrowsFromIt) {
  const Mask liver = ball();
  const VesselTrees trees = some_trees();
  const auto territories = territories_of(trees, System::portal_vein, liver).value();
  double all = 0, voxels = 0;
  for (const double ml : territories.volume_ml) all += ml;
  for (const std::uint8_t v : liver.values) voxels += v;
  EXPECT_NEAR(all, voxels * liver.grid.voxel_volume_mm3() / 1000, 1e-6);
  EXPECT_EQ(territories.volume_ml[3], 0) << "a hepatic vein has no portal territory";
  EXPECT_NEAR(volumes_beyond_ml(trees, territories)[0], all, 1e-6);
}

TEST(Territories, GoThroughTheLiverAndNotAcrossACleft) {
  Mask liver = ball();
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        const Vector3d p = liver.grid.position_mm(i, j, k);
        if (std::abs(p.x() - 6) < 2 && p.z() > -30) liver.at(i, j, k) = 0;  // open at the bottom alone
      }
    }
  }
  VesselTrees trees;
  trees.branches.push_back(straight(System::portal_vein, -1, {0, 0, 20}, {0, 0, 25}, 1));
  trees.branches.push_back(straight(System::portal_vein, -1, {30, 0, 0}, {32, 0, 0}, 1));
  const auto territories = territories_of(trees, System::portal_vein, liver).value();
  const Vector3d beyond = liver.grid.index_of({10, 0, 22});  // 10 mm from the first, 30 mm from the second
  EXPECT_EQ(territories.branch[liver.grid.offset(static_cast<int>(std::lround(beyond.x())),
                                                 static_cast<int>(std::lround(beyond.y())),
                                                 static_cast<int>(std::lround(beyond.z())))],
            1);
}

TEST(Territories, WithoutABranchOrALiverAreRefusedWithASentence) {
  VesselTrees none;
  EXPECT_EQ(territories_of(none, System::portal_vein, ball()).error().code, "territories-no-branch");
  VesselTrees outside;
  outside.branches.push_back(straight(System::portal_vein, -1, {300, 0, 0}, {320, 0, 0}, 2));
  EXPECT_EQ(territories_of(outside, System::portal_vein, ball()).error().code, "territories-no-branch");
  Mask empty = ball();
  std::fill(empty.values.begin(), empty.values.end(), std::uint8_t{0});
  EXPECT_EQ(territories_of(some_trees(), System::portal_vein, empty).error().code, "liver-empty");
}

}  // namespace
}  // namespace glisson::vasculature
