// Portal and hepatic veins told apart where it can be said without a program which is which.

#include "vasculature/systems.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "drawn_vessels.h"
#include "vasculature/center_lines.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using test::draw;

constexpr double portal_y = 22.5, hepatic_y = 26;

// Two vessels that cross and touch, each of which divides beyond: the portal vein comes in at the left, the hepatic
// vein at the right, and both thin out.
imaging::Mask crossing() {
  imaging::Mask mask;
  mask.grid.size = {110, 50, 110};
  mask.values.assign(mask.grid.voxels(), 0);
  for (const double right : {0.0, 1.0}) {
    const double y = right > 0 ? hepatic_y : portal_y;
    const auto place = [&](double x, double z) { return Vector3d(right > 0 ? 109 - x : x, y, z); };
    draw(mask, place(8, 20), place(60, 60), 2.8);
    draw(mask, place(60, 60), place(75, 100), 2.2);
    draw(mask, place(60, 60), place(100, 66), 2.2);
  }
  return mask;
}

TEST(Systems, AVesselGoesStraightOnWhereItCrossesAnother) {
  const auto graph = center_lines(crossing());
  ASSERT_TRUE(graph) << graph.error().message();
  const VesselTrees trees = classify_vessels(*graph, {{8, portal_y, 20}, {101, hepatic_y, 20}, 1});
  double right = 0, all = 0;
  for (const TreeBranch& branch : trees.branches) {
    for (const CenterPoint& point : branch.points) {
      const double y = point.position_mm.y();
      if (std::abs(y - 0.5 * (portal_y + hepatic_y)) < 1) continue;  // on its way from one to the other
      ++all;
      if ((branch.system == System::hepatic_vein) == (y > 0.5 * (portal_y + hepatic_y))) ++right;
    }
  }
  EXPECT_GT(all, 200);
  EXPECT_GT(right, 0.95 * all);
}

TEST(Systems, AClickTellsTheSystemOfWhatItLiesOn) {
  const auto graph = center_lines(crossing());
  ASSERT_TRUE(graph) << graph.error().message();
  // Expected the wrong way round.
  const VesselEntries expected{{101, hepatic_y, 20}, {8, portal_y, 20}, 1};
  const VesselTrees trees = classify_vessels(
      *graph, expected, {},
      {{Vessel::portal_vein, Vector3d(20, portal_y, 29)}, {Vessel::hepatic_vein, Vector3d(90, hepatic_y, 29)}});
  for (const TreeBranch& branch : trees.branches) {
    for (const CenterPoint& point : branch.points) {
      const double from_portal = (point.position_mm - Vector3d(20, portal_y, 29)).norm();
      const double from_hepatic = (point.position_mm - Vector3d(90, hepatic_y, 29)).norm();
      if (std::min(from_portal, from_hepatic) > 4) continue;
      EXPECT_EQ(branch.system, from_portal < from_hepatic ? System::portal_vein : System::hepatic_vein);
    }
  }
}

TEST(Systems, WhatFollowsFromAClickFollowsIt) {
  const auto graph = center_lines(crossing());
  ASSERT_TRUE(graph) << graph.error().message();
  // Nothing is known of where vessels enter; the stem is told at its far end, and its own branches go with it.
  const VesselEntries expected{{55, 0, 0}, {55, 0, 0}, 1};
  for (const Vessel vessel : {Vessel::umbilical_portion, Vessel::right_hepatic_vein}) {
    const VesselTrees trees = classify_vessels(*graph, expected, {}, {{vessel, Vector3d(20, portal_y, 29)}});
    ASSERT_EQ(trees.clicks.size(), 1u);
    for (const TreeBranch& branch : trees.branches) {
      for (const CenterPoint& point : branch.points) {
        if ((point.position_mm - Vector3d(20, portal_y, 29)).norm() > 15) continue;
        EXPECT_EQ(branch.system, system_of(vessel));
        EXPECT_DOUBLE_EQ(branch.confidence, 1) << "what is told is in no doubt";
      }
    }
  }
}

TEST(Systems, EachVesselHasAName) {
  for (const Vessel vessel : all_vessels) EXPECT_EQ(vessel_named(vessel_name(vessel)), vessel);
  EXPECT_FALSE(vessel_named("vena-cava"));
}

}  // namespace
}  // namespace glisson::vasculature
