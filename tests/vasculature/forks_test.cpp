// Forks are where vessels of a mask divide, and nowhere else.

#include "vasculature/forks.h"

#include <gtest/gtest.h>
#include <algorithm>

#include "vasculature/center_lines.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;

struct Tube {
  Vector3d from_mm, to_mm;
  double radius_mm;
};

imaging::Mask mask_of(const std::vector<Tube>& tubes) {
  imaging::Mask mask;
  mask.grid.size = {100, 60, 100};
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 100; ++i) {
        const Vector3d place = mask.grid.position_mm(i, j, k);
        const auto inside = [&](const Tube& tube) {
          const Vector3d along = tube.to_mm - tube.from_mm;
          const double t = std::clamp((place - tube.from_mm).dot(along) / along.squaredNorm(), 0.0, 1.0);
          return (place - tube.from_mm - t * along).norm() <= tube.radius_mm;
        };
        mask.values.push_back(std::any_of(tubes.begin(), tubes.end(), inside) ? 1 : 0);
      }
    }
  }
  return mask;
}

// A stem that divides in two, one of which divides again, all in the plane y = 30.
TEST(Forks, LieWhereTheVesselsOfAMaskDivide) {
  const Vector3d first(50, 30, 40), second(72, 30, 65);
  const auto graph = center_lines(mask_of({{{50, 30, 6}, first, 4.5},
                                           {first, {22, 30, 80}, 3},
                                           {first, second, 3.2},
                                           {second, {90, 30, 72}, 1.6},
                                           {second, {72, 30, 92}, 1.6}}));
  ASSERT_TRUE(graph) << graph.error().message();
  const VesselTrees trees = known_vessels(*graph, {}, {{50, 30, 6}, {50, 30, 99}, 1});
  const std::vector<Fork> forks = forks_of(trees);
  ASSERT_EQ(forks.size(), 2u);
  const bool in_order = (forks[0].position_mm - first).norm() < (forks[1].position_mm - first).norm();
  const Fork &stem = forks[in_order ? 0 : 1], &side = forks[in_order ? 1 : 0];
  EXPECT_LT((stem.position_mm - first).norm(), 4.5);  // within the vessel
  EXPECT_LT((side.position_mm - second).norm(), 3.2);
  EXPECT_NEAR(stem.calibre_mm, 9, 1.5);
  EXPECT_NEAR(side.calibre_mm, 6.4, 1.5);
  EXPECT_EQ(stem.branches, 2);

  // Of wider vessels alone, only the stem's.
  EXPECT_EQ(forks_of(trees, 7.8).size(), 1u);
}

TEST(Forks, AreNoGapsContactsOrBends) {
  const auto branch = [](int parent, Joint joint, double radius_mm) {
    TreeBranch made;
    made.parent = parent;
    made.joint = joint;
    made.radius_mm = radius_mm;
    made.points = {{{0, 0, 0}, radius_mm}, {{10, 0, 0}, radius_mm}};
    return made;
  };
  VesselTrees trees;
  trees.branches = {branch(-1, Joint::vessel, 4), branch(0, Joint::vessel, 3), branch(0, Joint::contact, 3)};
  EXPECT_TRUE(forks_of(trees).empty());  // the second way out is a contact
  trees.branches[2].joint = Joint::gap;
  EXPECT_TRUE(forks_of(trees).empty());
  trees.branches[2].joint = Joint::vessel;
  ASSERT_EQ(forks_of(trees).size(), 1u);
  EXPECT_EQ(forks_of(trees)[0].position_mm, Vector3d(10, 0, 0));
  trees.branches[0].joint = Joint::gap;  // a bridge that ends at two vessels
  EXPECT_TRUE(forks_of(trees).empty());
}

}  // namespace
}  // namespace glisson::vasculature
