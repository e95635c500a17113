// How near cuts come to tumours: the smallest margin, and the margins all over a cut that is unrolled.

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>

#include "geometry/cut_surface.h"
#include "planning/parts_of_a_ball.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;
using vasculature::ball;

TEST(Margins, AreMeasuredToWithinAVoxel) {
  LiverParts parts = parts_of_ball();
  parts.tumours.push_back({"tumour-2", ball_at(parts.liver, {20, -10, 5}, 5)});
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner);
  for (const double away_mm : {1.0, 3.3, 6.2, 11.0, 16.0}) {
    for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(1, 0.4, -0.3), Vector3d(0.3, 0.2, 1)}) {
      const Vector3d normal = way.normalized();
      const auto answer =
          planner->answer({PlaneCut{tumour_mm + (tumour_radius_mm + away_mm) * normal, -normal, Removed::above}});
      ASSERT_TRUE(answer);
      EXPECT_EQ(answer->tumours.front().side, Side::removed);
      EXPECT_NEAR(answer->tumours.front().margin_mm, away_mm, 0.75) << way.transpose();
      EXPECT_EQ(answer->tumours.back().side, (Vector3d(20, -10, 5) - tumour_mm).dot(normal) > 12 + away_mm
                                                 ? Side::left
                                                 : answer->tumours.back().side);
    }
  }
  const auto around = planner->answer({MarginCut{"tumour-1", 8}});
  ASSERT_TRUE(around);
  EXPECT_NEAR(*around->margin_mm, 8, 0.1);
  EXPECT_EQ(around->tumours.back().side, Side::left);
  const auto through = planner->answer({PlaneCut{tumour_mm, {1, 0, 0}, Removed::smaller}});
  EXPECT_EQ(through->tumours.front().side, Side::cut_through);
  EXPECT_EQ(through->margin_mm, 0.0);
}

TEST(Margins, OfAblationsAreMeasured) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  for (const double margin_mm : {2.0, 5.0, 8.0}) {
    const double radius_mm = tumour_radius_mm + margin_mm;
    const auto centred = planner->answer({AblationCut{tumour_mm, {0, 0, 1}, radius_mm, radius_mm}});
    ASSERT_TRUE(centred);
    EXPECT_EQ(centred->tumours.front().side, Side::removed);
    EXPECT_NEAR(centred->tumours.front().margin_mm, margin_mm, 0.75);
    const auto longer = planner->answer({AblationCut{tumour_mm, {0, 1, 0}, radius_mm + 9, radius_mm}});
    EXPECT_NEAR(longer->tumours.front().margin_mm, margin_mm, 0.75);
    const auto aside = planner->answer({AblationCut{tumour_mm + Vector3d(1.5, 0, 0), {0, 0, 1}, radius_mm, radius_mm}});
    EXPECT_NEAR(aside->tumours.front().margin_mm, margin_mm - 1.5, 0.75);
  }
  EXPECT_EQ(planner->answer({AblationCut{tumour_mm, {0, 0, 1}, 5, 5}})->tumours.front().side, Side::cut_through);
  EXPECT_EQ(planner->answer({AblationCut{{900, 0, 0}, {0, 0, 1}, 5, 5}}).error().code, "cut-misses");
  EXPECT_EQ(planner->answer({AblationCut{tumour_mm, {0, 0, 0}, 5, 5}}).error().code, "ablation-invalid");
  EXPECT_EQ(planner->answer({AblationCut{tumour_mm, {0, 0, 1}, 5, 0}}).error().code, "ablation-invalid");
  EXPECT_EQ(planner->answer({AblationCut{tumour_mm, {0, 0, 1}, 5, 1e9}}).error().code, "ablation-invalid");
}

// At each place of a plane, and of a bent sheet, the distance to the tumour's border, and the vessels that are cut.
TEST(Margins, AreUnrolledWithTheirCut) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  SheetCut sheet;
  for (const double y : {-35.0, -10.0, 15.0, 35.0}) {
    for (const double z : {-30.0, -5.0, 20.0, 38.0}) sheet.through_mm.emplace_back(4 + 5 * std::sin(y / 12), y, z);
  }
  const PlaneCut plane{{3, 0, 0}, {1, 0.2, 0}, Removed::smaller};
  const geometry::CutSurface surfaces[] = {geometry::CutSurface::plane(plane.point_mm, plane.normal).value(),
                                           geometry::CutSurface::through(sheet.through_mm).value()};
  const std::vector<Cut> cuts = {plane, sheet};
  for (std::size_t n = 0; n < 2; ++n) {
    const auto found = planner->answer_unrolled({cuts[n]});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->resectograms.size(), 1u);
    const Resectogram& map = found->resectograms.front();
    // By the voxels themselves: those that the surface passes through.
    double nearest_mm = 1e9, area_mm2 = 0, closest_mm = 1e9;
    for_each_voxel(ball(), [&](int, int, int, const Vector3d& at) {
      if (std::abs(surfaces[n].height_mm(at)) > 0.5) return;
      nearest_mm = std::min(nearest_mm, std::max(0.0, (at - tumour_mm).norm() - tumour_radius_mm));
    });
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) {
        if (std::isnan(map.at(column, row))) continue;
        area_mm2 += map.step_mm * map.step_mm;
        closest_mm = std::min(closest_mm, map.at(column, row));
      }
    }
    EXPECT_NEAR(closest_mm, nearest_mm, 1);
    // Its axes lie across the surface's normal, as places a millimetre on along them do.
    for (const auto& [axis, across] :
         {std::pair{map.along_row, Eigen::Vector2d(1, 0)}, std::pair{map.along_column, Eigen::Vector2d(0, 1)}}) {
      EXPECT_NEAR(axis.norm(), 1, 1e-12);
      EXPECT_NEAR(axis.dot(surfaces[n].normal()), 0, 1e-12);
      EXPECT_LT((surfaces[n].across_mm(surfaces[n].point_mm() + axis) - surfaces[n].across_mm(surfaces[n].point_mm()) -
                 across)
                    .norm(),
                1e-9);
    }
    const double disc_mm2 = 3.14159265 * (40 * 40 - 9);
    EXPECT_NEAR(area_mm2, disc_mm2, (n == 0 ? 0.02 : 0.1) * disc_mm2);
    EXPECT_EQ(map.vessels.size(), found->answer.branches.size());
    for (const auto& vessel : map.vessels) {
      EXPECT_FALSE(vessel.name.empty());
      EXPECT_TRUE(vessel.column > 0 && vessel.column < map.columns && vessel.row > 0 && vessel.row < map.rows);
    }
  }
  EXPECT_TRUE(planner->answer_unrolled({SegmentsCut{{2}}})->resectograms.empty());
}

// Two cuts at once: a map each, as of each alone; a branch stands on one of them; the answer is the plan's.
TEST(Margins, AreUnrolledForEachCutOfAPlan) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  const std::vector<Cut> cuts = {PlaneCut{{10, 0, 0}, {1, 0, 0}, Removed::smaller}, SegmentsCut{{1}},
                                 PlaneCut{{0, 0, 20}, {0, 0, 1}, Removed::smaller}};
  const auto together = planner->answer_unrolled(cuts), first = planner->answer_unrolled({cuts.front()}),
             last = planner->answer_unrolled({cuts.back()});
  ASSERT_TRUE(together && first && last);
  ASSERT_EQ(together->resectograms.size(), 2u);
  const auto known = [](const Resectogram& map) {
    return std::count_if(map.margin_mm.begin(), map.margin_mm.end(), [](double mm) { return !std::isnan(mm); });
  };
  for (const auto& [map, alone] : {std::pair{together->resectograms.front(), first->resectograms.front()},
                                   std::pair{together->resectograms.back(), last->resectograms.back()}}) {
    EXPECT_EQ(map.columns, alone.columns);
    EXPECT_EQ(map.rows, alone.rows);
    EXPECT_EQ(known(map), known(alone));
    EXPECT_GT(known(map), 1000);
  }
  const auto answer = planner->answer(cuts);
  ASSERT_TRUE(answer);
  EXPECT_EQ(together->answer.removed_ml, answer->removed_ml);
  EXPECT_EQ(together->answer.living_ml, answer->living_ml);
  const std::size_t drawn =
      together->resectograms.front().vessels.size() + together->resectograms.back().vessels.size();
  EXPECT_GT(drawn, 0u);
  EXPECT_LE(drawn, answer->branches.size());
}

}  // namespace
}  // namespace glisson::planning
