// What lives after a cut, against brute force: every voxel looks for the nearest vessel itself and walks its way back
// to the stem, point by point.

#include "vasculature/remnant.h"

#include <gmock/gmock.h>
#include <cmath>

#include "vessels_in_a_ball.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

VesselTrees some_trees() {
  VesselTrees trees;
  trees.branches.push_back(straight(System::portal_vein, -1, {0, 0, -30}, {0, 0, 0}, 3));
  trees.branches.push_back(straight(System::portal_vein, 0, {0, 0, 0}, {25, 5, 15}, 3));
  trees.branches.push_back(straight(System::portal_vein, 0, {0, 0, 0}, {-25, -5, 10}, 2));
  trees.branches.push_back(straight(System::portal_vein, 1, {15, 3, 9}, {0, 25, 20}, 2));  // back across the cut
  trees.branches.push_back(straight(System::hepatic_vein, -1, {0, 30, 20}, {0, 0, 10}, 3));
  trees.branches.push_back(straight(System::hepatic_vein, 4, {0, 0, 10}, {20, -20, 0}, 2));
  trees.branches.push_back(straight(System::hepatic_vein, 4, {0, 0, 10}, {-20, -20, 0}, 2));
  return trees;
}

// All to the right of x = 10 mm.
Mask right_of_10(const Mask& liver) {
  Mask removed = liver;
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        if (liver.grid.position_mm(i, j, k).x() <= 10) removed.at(i, j, k) = 0;
      }
    }
  }
  return removed;
}

// Walks from the point of a branch to the stem: whether any of it lies to the right of 10 mm.
bool is_cut_off(const VesselTrees& trees, int branch, int point) {
  while (branch >= 0) {
    const TreeBranch& here = trees.branches[static_cast<std::size_t>(branch)];
    for (int p = point; p >= 0; --p) {
      if (std::lround(here.points[static_cast<std::size_t>(p)].position_mm.x() + 41) > 51) return true;
    }
    const Vector3d joint = here.points.front().position_mm;
    branch = here.parent;
    if (branch < 0) break;
    const TreeBranch& parent = trees.branches[static_cast<std::size_t>(branch)];
    double nearest_mm = 1e9;
    for (int p = 0; p < static_cast<int>(parent.points.size()); ++p) {
      const double away = (parent.points[static_cast<std::size_t>(p)].position_mm - joint).norm();
      if (away < nearest_mm) nearest_mm = away, point = p;
    }
  }
  return false;
}

double cut_off_ml(const VesselTrees& trees, System system, const Mask& liver, const Mask& removed) {
  double ml = 0;
  for (int k = 0; k < liver.grid.size[2]; ++k) {
    for (int j = 0; j < liver.grid.size[1]; ++j) {
      for (int i = 0; i < liver.grid.size[0]; ++i) {
        if (liver.at(i, j, k) == 0 || removed.at(i, j, k) != 0) continue;
        const Vector3d at = liver.grid.position_mm(i, j, k);
        double nearest_mm = 1e9;
        int branch = -1, point = 0;
        for (int b = 0; b < static_cast<int>(trees.branches.size()); ++b) {
          const TreeBranch& tried = trees.branches[static_cast<std::size_t>(b)];
          if (tried.system != system) continue;
          for (int p = 0; p < static_cast<int>(tried.points.size()); ++p) {
            const CenterPoint& there = tried.points[static_cast<std::size_t>(p)];
            const double away = (there.position_mm - at).norm() - there.radius_mm;
            if (away < nearest_mm) nearest_mm = away, branch = b, point = p;
          }
        }
        if (is_cut_off(trees, branch, point)) ml += liver.grid.voxel_volume_mm3() / 1000;
      }
    }
  }
  return ml;
}

TEST(Remnant, IsWhatBruteForceFinds) {
  const Mask liver = ball(), removed = right_of_10(liver);
  const VesselTrees trees = some_trees();
  const auto portal = territories_of(trees, System::portal_vein, liver);
  const auto hepatic = territories_of(trees, System::hepatic_vein, liver);
  ASSERT_TRUE(portal && hepatic);
  const auto remnant = remnant_of(trees, *portal, *hepatic, removed);
  ASSERT_TRUE(remnant) << remnant.error().message();
  EXPECT_NEAR(remnant->removed_ml + remnant->remnant_ml, 4.0 / 3 * 3.14159265 * 64, 0.5);
  EXPECT_NEAR(remnant->perfused_ml + remnant->ischaemic_ml, remnant->remnant_ml, 1e-6);
  EXPECT_NEAR(remnant->drained_ml + remnant->congested_ml, remnant->remnant_ml, 1e-6);
  const double ischaemic_ml = cut_off_ml(trees, System::portal_vein, liver, removed);
  const double congested_ml = cut_off_ml(trees, System::hepatic_vein, liver, removed);
  EXPECT_GT(ischaemic_ml, 20);  // what the branch that turns back feeds
  EXPECT_NEAR(remnant->ischaemic_ml, ischaemic_ml, 0.01 * remnant->remnant_ml);
  EXPECT_NEAR(remnant->congested_ml, congested_ml, 0.01 * remnant->remnant_ml);
  // Two vessels meet the cut; the branch that hangs on one of them is not listed again.
  ASSERT_EQ(remnant->cut.size(), 2u);
  EXPECT_EQ(remnant->cut.front().branch, 1u);
  EXPECT_EQ(remnant->cut.back().branch, 5u);
  EXPECT_NEAR(remnant->cut.front().affected_ml + remnant->cut.back().affected_ml,
              remnant->ischaemic_ml + remnant->congested_ml, 1e-6);
  EXPECT_NEAR(remnant->cut.front().at_mm.x(), 10.5, 1);
}

TEST(Remnant, OfACutThatMeetsNoVesselLivesWhole) {
  const Mask liver = ball();
  Mask removed = right_of_10(liver);
  for (std::uint8_t& value : removed.values) value = 0;
  removed.at(42, 2, 28) = 1;
  const VesselTrees trees = some_trees();
  const auto portal = territories_of(trees, System::portal_vein, liver);
  const auto hepatic = territories_of(trees, System::hepatic_vein, liver);
  const auto remnant = remnant_of(trees, *portal, *hepatic, removed);
  ASSERT_TRUE(remnant);
  EXPECT_TRUE(remnant->cut.empty());
  EXPECT_DOUBLE_EQ(remnant->living_ml, remnant->remnant_ml);
  Mask other = removed;
  other.grid.origin_mm.x() += 1;
  EXPECT_EQ(remnant_of(trees, *portal, *hepatic, other).error().code, "remnant-grids");
}

}  // namespace
}  // namespace glisson::vasculature
