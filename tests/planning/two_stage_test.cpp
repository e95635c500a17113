// Embolisation before a cut: what shrinks, what grows and what is left after, judged voxel by voxel.

#include "planning/two_stage.h"

#include <cmath>

#include "parts_of_a_ball.h"

namespace glisson::planning {
namespace {

TEST(TwoStages, AreCountedAsTheVoxelsSay) {
  const LiverParts parts = parts_of_ball();
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner);
  const PlaneCut plane{{-18, 0, 0}, {1, 0, 0}, Removed::below};
  const auto stages = two_stages(*planner, {"portal/right"}, {plane}, 40);
  ASSERT_TRUE(stages) << stages.error().message();
  double all = 0, embolised = 0, fed = 0, embolised_left = 0;
  for_each_voxel(parts.liver, [&](int i, int j, int k, const Eigen::Vector3d& at) {
    if (parts.tumours.front().mask.at(i, j, k) != 0) return;
    const bool on_right = parts.trees.branches[parts.portal->at(i, j, k) - 1U].name == "portal/right";
    const bool stays = at.x() > -18;
    all += 1;
    embolised += on_right ? 1 : 0;
    fed += stays && !on_right ? 1 : 0;
    embolised_left += stays && on_right ? 1 : 0;
  });
  const double ml = parts.liver.grid.voxel_volume_mm3() / 1000;
  ASSERT_GT(embolised_left, 100);
  EXPECT_NEAR(stages->embolised_ml, embolised * ml, 0.01 * embolised * ml);
  EXPECT_NEAR(stages->grows_ml, fed * ml, 0.01 * fed * ml);
  EXPECT_NEAR(stages->embolised_left_ml, embolised_left * ml, 0.01 * embolised_left * ml);
  EXPECT_NEAR(stages->grown_ml, 1.4 * stages->grows_ml, 1e-9);
  EXPECT_NEAR(stages->remnant_percent, 100 * (fed + embolised_left) / all, 0.5);
  EXPECT_NEAR(stages->grown_percent, 140 * fed / all, 0.5);
}

TEST(TwoStages, SayWhatCannotBeAsked) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  const std::vector<Cut> cuts = {PlaneCut{{-18, 0, 0}, {1, 0, 0}, Removed::below}};
  EXPECT_EQ(two_stages(*planner, {}, cuts).error().code, "embolised-none");
  EXPECT_EQ(two_stages(*planner, {"hepatic/left"}, cuts).error().code, "embolised-not-portal");
  EXPECT_EQ(two_stages(*planner, {"portal/middle"}, cuts).error().code, "branch-unknown");
  EXPECT_EQ(two_stages(*planner, {"portal/right"}, cuts, -1).error().code, "growth-invalid");
  EXPECT_EQ(two_stages(*planner, {"portal/right"}, cuts, std::nan("")).error().code, "growth-invalid");
  EXPECT_EQ(two_stages(*planner, {"portal/right"}, {}).error().code, "plan-empty");
  EXPECT_EQ(two_stages(*planner, {"portal"}, cuts).error().code, "nothing-left");
}

}  // namespace
}  // namespace glisson::planning
