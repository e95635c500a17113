// Centre lines of vessels that are drawn by hand: what they must be can be said without a program.

#include <gmock/gmock.h>
#include <cmath>

#include "drawn_vessels.h"
#include "vasculature/center_lines.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;
using test::draw;

Mask empty_mask(int size = 90) {
  Grid grid;
  grid.size = {size, size, size};
  grid.spacing_mm = {0.8, 0.8, 0.8};
  grid.origin_mm = {-20, -30, 10};
  return {grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
}

double length_of(const VesselGraph& graph, Joint joint) {
  double length = 0;
  for (const GraphBranch& branch : graph.branches) {
    if (branch.joint == joint) length += branch.length_mm;
  }
  return length;
}

TEST(CenterLines, OfOneCylinderAreItsAxisWithItsRadius) {
  Mask mask = empty_mask();
  const Vector3d from(-10, -20, 20), to(30, 20, 60);
  draw(mask, from, to, 3);
  const auto graph = center_lines(mask);
  ASSERT_TRUE(graph) << graph.error().message();
  const Vector3d axis = (to - from).normalized();
  int inner = 0;
  for (const GraphBranch& branch : graph->branches) {
    for (const CenterPoint& point : branch.points) {
      const Vector3d way = point.position_mm - from;
      const double along = way.dot(axis);
      if (along < 8 || along > (to - from).norm() - 8) continue;
      ++inner;
      EXPECT_LT((way - along * axis).norm(), 0.8) << "off the axis at " << along << " mm";
      EXPECT_NEAR(point.radius_mm, 3, 0.4) << "at " << along << " mm";
    }
  }
  EXPECT_GT(inner, 30);
}

TEST(CenterLines, OfAForkAreThreeBranchesThatMeet) {
  Mask mask = empty_mask();
  const Vector3d fork(10, 0, 40);
  draw(mask, {10, 0, 14}, fork, 4);
  draw(mask, fork, {30, 0, 70}, 2.5);
  draw(mask, fork, {-10, 0, 70}, 2.5);
  const auto graph = center_lines(mask);
  ASSERT_TRUE(graph) << graph.error().message();
  const auto at = graph->branches_at_vertices();
  int ends = 0, forks = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].size() == 1) ++ends;
    if (at[v].size() >= 3) {
      ++forks;
      EXPECT_LT((graph->vertices_mm[v] - fork).norm(), 6);
    }
  }
  EXPECT_EQ(ends, 3);
  EXPECT_EQ(forks, 1);
}

TEST(CenterLines, AGapOfAFewVoxelsIsBridged) {
  Mask mask = empty_mask();
  draw(mask, {10, 0, 14}, {10, 0, 38}, 2);
  draw(mask, {10, 0, 45}, {10, 0, 75}, 2);  // 3 mm between the round ends
  const auto graph = center_lines(mask);
  ASSERT_TRUE(graph) << graph.error().message();
  EXPECT_GT(length_of(*graph, Joint::gap), 2);
  EXPECT_LT(length_of(*graph, Joint::gap), 8);
  CenterLineOptions none;
  none.maximum_gap_mm = 1;
  EXPECT_EQ(length_of(center_lines(mask, none).value(), Joint::gap), 0);
}

// The two ends hang together by a way round, as where a vessel touches another one beyond its gap.
TEST(CenterLines, AGapIsBridgedWhereItsEndsHangTogetherElsewhere) {
  Mask mask = empty_mask();
  draw(mask, {-8, 0, 20}, {8, 0, 20}, 2.5);
  draw(mask, {14.5, 0, 20}, {30, 0, 20}, 2.5);
  for (const double x : {-8.0, 30.0}) draw(mask, {x, 0, 20}, {x, 0, 60}, 2.5);
  draw(mask, {-8, 0, 60}, {30, 0, 60}, 2.5);
  const auto graph = center_lines(mask);
  ASSERT_TRUE(graph) << graph.error().message();
  const auto over_the_gap = [](const GraphBranch& branch) {
    return branch.joint == Joint::gap && std::abs(branch.points.front().position_mm.z() - 20) < 2;
  };
  EXPECT_EQ(std::count_if(graph->branches.begin(), graph->branches.end(), over_the_gap), 1);
}

TEST(CenterLines, TheSameMaskGivesTheSameGraph) {
  Mask mask = empty_mask(50);
  draw(mask, {-10, -20, 20}, {10, 0, 40}, 3);
  draw(mask, {0, -10, 30}, {10, -20, 20}, 2);
  const auto a = center_lines(mask).value(), b = center_lines(mask).value();
  ASSERT_EQ(a.branches.size(), b.branches.size());
  for (std::size_t n = 0; n < a.branches.size(); ++n) {
    ASSERT_EQ(a.branches[n].points.size(), b.branches[n].points.size());
    for (std::size_t i = 0; i < a.branches[n].points.size(); ++i) {
      EXPECT_EQ(a.branches[n].points[i].position_mm, b.branches[n].points[i].position_mm);
    }
  }
}

TEST(CenterLines, WhatIsNoVesselMaskIsRefusedWithASentence) {
  EXPECT_EQ(center_lines(empty_mask(20)).error().code, "vessels-empty");
  Mask blob = empty_mask();
  draw(blob, {10, 0, 40}, {10, 0, 42}, 20);
  const auto refused = center_lines(blob);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "vessels-one-blob");
  EXPECT_THAT(refused.error().message(), testing::HasSubstr("mm width"));
  Mask tilted = empty_mask(20);
  tilted.values[0] = 1;
  tilted.grid.direction(0, 2) = 0.3;
  EXPECT_EQ(center_lines(tilted).error().code, "vessels-grid");
}

}  // namespace
}  // namespace glisson::vasculature
