// Answers to cuts against a slow judge that shares no code with the planner: every voxel asks for itself whether it
// goes, what it hangs on and whether the way back to the stem is whole.

#include "planning/planner.h"

#include <gmock/gmock.h>
#include <cmath>
#include <functional>

#include "geometry/cut_surface.h"
#include "planning/parts_of_a_ball.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;
using imaging::Mask;
using vasculature::ball;
using vasculature::straight;
using vasculature::System;
using vasculature::TreeBranch;
using vasculature::VesselTrees;

using Goes = std::function<bool(const Vector3d&)>;

struct Nearest {
  int branch = -1, point = 0;
};
Nearest nearest_vessel(const VesselTrees& trees, System system, const Vector3d& at) {
  Nearest nearest;
  double nearest_mm = 1e9;
  for (int b = 0; b < static_cast<int>(trees.branches.size()); ++b) {
    const TreeBranch& tried = trees.branches[static_cast<std::size_t>(b)];
    if (tried.system != system) continue;
    for (int p = 0; p < static_cast<int>(tried.points.size()); ++p) {
      const auto& there = tried.points[static_cast<std::size_t>(p)];
      const double away = (there.position_mm - at).norm() - there.radius_mm;
      if (away < nearest_mm) nearest_mm = away, nearest = {b, p};
    }
  }
  return nearest;
}

// Walks from the point of a branch to the stem, past every point on the way, until `visit` has seen enough.
void walk_to_stem(const VesselTrees& trees, Nearest from, const std::function<bool(const Nearest&)>& visit) {
  while (from.branch >= 0) {
    const TreeBranch& here = trees.branches[static_cast<std::size_t>(from.branch)];
    for (; from.point >= 0; --from.point) {
      if (!visit(from)) return;
    }
    const Vector3d joint = here.points.front().position_mm;
    from = {here.parent, 0};
    if (from.branch < 0) return;
    const TreeBranch& parent = trees.branches[static_cast<std::size_t>(from.branch)];
    double nearest_mm = 1e9;
    for (int p = 0; p < static_cast<int>(parent.points.size()); ++p) {
      const double away = (parent.points[static_cast<std::size_t>(p)].position_mm - joint).norm();
      if (away < nearest_mm) nearest_mm = away, from.point = p;
    }
  }
}

// Whether vessels that only run through are spared.
enum class Along { surface, anatomy };

// What a voxel hangs on. Where vessels are spared, by the territories that the planner is given: the half of a vessel's
// tissue is reached at one of its points, and half a voxel more or less here and there would move it to the next.
Nearest hangs_on(const LiverParts& parts, System system, Along along, int i, int j, int k) {
  const Vector3d at = parts.liver.grid.position_mm(i, j, k);
  if (along == Along::surface) return nearest_vessel(parts.trees, system, at);
  const int branch = (system == System::portal_vein ? parts.portal : parts.hepatic)->at(i, j, k) - 1;
  Nearest nearest{branch, 0};
  double nearest_mm = 1e9;
  const auto& points = parts.trees.branches[static_cast<std::size_t>(branch)].points;
  for (int p = 0; p < static_cast<int>(points.size()); ++p) {
    const double away = (points[static_cast<std::size_t>(p)].position_mm - at).norm();
    if (away < nearest_mm) nearest_mm = away, nearest.point = p;
  }
  return nearest;
}

// Where vessels are cut. Points stand for the voxels they fall into.
using IsCut = std::function<bool(const Nearest&)>;
IsCut cutting(const LiverParts& parts, const Goes& goes, Along along) {
  const auto goes_at = [&parts, goes](const Nearest& at) {
    const auto& point =
        parts.trees.branches[static_cast<std::size_t>(at.branch)].points[static_cast<std::size_t>(at.point)];
    const Vector3d index = parts.liver.grid.index_of(point.position_mm);
    return goes(parts.liver.grid.position_mm(Vector3d((index.array() + 0.5).floor())));
  };
  if (along == Along::surface) return goes_at;
  std::map<std::pair<int, int>, std::pair<int, int>> hang;  // on each point: all voxels, and those that go
  for (const System system : {System::portal_vein, System::hepatic_vein}) {
    for_each_voxel(parts.liver, [&](int i, int j, int k, const Vector3d& at) {
      const bool is_gone = goes(at);
      walk_to_stem(parts.trees, hangs_on(parts, system, along, i, j, k), [&](const Nearest& passed) {
        auto& [all, gone] = hang[{passed.branch, passed.point}];
        ++all;
        gone += is_gone ? 1 : 0;
        return true;
      });
    });
  }
  return [goes_at, hang](const Nearest& at) {
    const auto found = hang.find({at.branch, at.point});
    return goes_at(at) && found != hang.end() && 2 * found->second.second >= found->second.first;
  };
}

bool is_cut_off(const VesselTrees& trees, const Nearest& from, const IsCut& is_cut) {
  bool found = false;
  walk_to_stem(trees, from, [&](const Nearest& passed) {
    found = is_cut(passed);
    return !found;
  });
  return found;
}

// What the judge finds.
struct Judged {
  double removed_ml = 0, left_ml = 0, functional_left_ml = 0, ischaemic_ml = 0, congested_ml = 0, living_ml = 0;
  std::array<double, 9> segment_left_ml{}, segment_kPa{}, segment_trusted_ml{};
};
Judged judged(const LiverParts& parts, const Goes& goes, Along along) {
  const IsCut is_cut = cutting(parts, goes, along);
  Judged judge;
  const double ml = parts.liver.grid.voxel_volume_mm3() / 1000;
  for_each_voxel(parts.liver, [&](int i, int j, int k, const Vector3d& at) {
    if (goes(at)) {
      judge.removed_ml += ml;
      return;
    }
    judge.left_ml += ml;
    const Nearest portal = hangs_on(parts, System::portal_vein, along, i, j, k);
    const Nearest hepatic = hangs_on(parts, System::hepatic_vein, along, i, j, k);
    const bool starved = is_cut_off(parts.trees, portal, is_cut);
    const bool held_up = is_cut_off(parts.trees, hepatic, is_cut);
    judge.ischaemic_ml += starved ? ml : 0;
    judge.congested_ml += held_up ? ml : 0;
    judge.living_ml += starved || held_up ? 0 : ml;
    if ((at - tumour_mm).norm() < tumour_radius_mm) return;
    judge.functional_left_ml += ml;
    const auto segment = static_cast<std::size_t>(octant(at));
    judge.segment_left_ml[segment] += ml;
    if (at.y() < -20.5) return;
    judge.segment_trusted_ml[segment] += ml;
    judge.segment_kPa[segment] += ml * stiffness_at(at);
  });
  return judge;
}

void expect_as_judged(const LiverParts& parts, const std::vector<Cut>& cuts, const Goes& goes,
                      Along along = Along::surface) {
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner) << planner.error().message();
  const auto answer = planner->answer(cuts);
  ASSERT_TRUE(answer) << answer.error().message();
  const Judged judge = judged(parts, goes, along);
  const double within_ml = 0.01 * judge.left_ml;
  EXPECT_NEAR(answer->removed_ml, judge.removed_ml, within_ml);
  EXPECT_NEAR(answer->remnant_ml, judge.left_ml, within_ml);
  EXPECT_NEAR(answer->functional_remnant_ml, judge.functional_left_ml, within_ml);
  EXPECT_NEAR(answer->ischaemic_ml.value_or(-1), judge.ischaemic_ml, within_ml);
  EXPECT_NEAR(answer->congested_ml.value_or(-1), judge.congested_ml, within_ml);
  EXPECT_NEAR(answer->living_ml.value_or(-1), judge.living_ml, within_ml);
  EXPECT_NEAR(*answer->perfused_ml + *answer->ischaemic_ml, answer->remnant_ml, 1e-6);
  EXPECT_NEAR(*answer->drained_ml + *answer->congested_ml, answer->remnant_ml, 1e-6);
  EXPECT_NEAR(answer->remnant_percent(), 100 * answer->functional_remnant_ml / answer->functional_ml(), 1e-9);
  double affected_ml = 0;
  for (const CutBranch& cut : answer->branches) {
    affected_ml += cut.affected_ml;
    EXPECT_GE(cut.beyond_ml, cut.affected_ml);
  }
  EXPECT_NEAR(affected_ml, *answer->ischaemic_ml + *answer->congested_ml, 1e-6);
  double segments_ml = 0;
  for (const SegmentAnswer& segment : answer->segments) {
    const auto s = static_cast<std::size_t>(segment.number);
    segments_ml += segment.left.ml;
    EXPECT_NEAR(segment.left.ml, judge.segment_left_ml[s], within_ml) << s;
    EXPECT_LE(segment.living_ml, segment.left.ml + 1e-9);
    if (judge.segment_left_ml[s] < 1) continue;
    EXPECT_NEAR(segment.left.confident_share, judge.segment_trusted_ml[s] / judge.segment_left_ml[s], 0.06) << s;
    EXPECT_NEAR(segment.left.mean_kPa.value_or(-1), judge.segment_kPa[s] / judge.segment_trusted_ml[s], 0.1) << s;
  }
  EXPECT_NEAR(segments_ml, answer->functional_remnant_ml, 1e-6);
}

TEST(Planner, AnswersAPlaneAsBruteForceDoes) {
  expect_as_judged(parts_of_ball(), {PlaneCut{{10, 0, 0}, {2, 0, 0}, Removed::smaller}},
                   [](const Vector3d& at) { return at.x() > 10; });
  expect_as_judged(parts_of_ball(), {PlaneCut{{-4, 0, 0}, {1, 1, 0.3}, Removed::above}},
                   [](const Vector3d& at) { return (at - Vector3d(-4, 0, 0)).dot(Vector3d(1, 1, 0.3)) > 0; });
  expect_as_judged(parts_of_ball(), {PlaneCut{{10, 0, 0}, {1, 0, 0}, Removed::larger}},
                   [](const Vector3d& at) { return at.x() <= 10; });
}

TEST(Planner, AnswersASheetAsBruteForceDoes) {
  SheetCut sheet;
  for (const double y : {-35.0, -10.0, 15.0, 35.0}) {
    for (const double z : {-30.0, -5.0, 20.0, 38.0}) sheet.through_mm.emplace_back(8 + 6 * std::sin(y / 12), y, z);
  }
  const auto surface = geometry::CutSurface::through(sheet.through_mm);
  ASSERT_TRUE(surface);
  const double sign = surface->height_mm({100, 0, 0}) > 0 ? 1 : -1;
  expect_as_judged(parts_of_ball(), {sheet}, [&](const Vector3d& at) { return sign * surface->height_mm(at) > 0; });
}

TEST(Planner, TakesSegmentsTerritoriesAndWhatIsAroundATumourTogether) {
  const LiverParts parts = parts_of_ball();
  expect_as_judged(
      parts, {SegmentsCut{{2, 6}}}, [](const Vector3d& at) { return octant(at) == 2 || octant(at) == 6; },
      Along::anatomy);
  expect_as_judged(
      parts, {TerritoryCut{"portal/left"}},
      [&](const Vector3d& at) {
        const int branch = nearest_vessel(parts.trees, System::portal_vein, at).branch;
        return branch == 1 || branch == 3;
      },
      Along::anatomy);
  // A voxel's border lies half a voxel beyond its centre, for the tumour as for what goes around it.
  const auto around = [](const Vector3d& at) { return (at - tumour_mm).norm() <= tumour_radius_mm + 4; };
  expect_as_judged(parts, {MarginCut{"tumour-1", 4}}, around);
  expect_as_judged(parts, {MarginCut{"tumour-1", 4}, PlaneCut{{15, 0, 0}, {1, 0, 0}, Removed::smaller}},
                   [&](const Vector3d& at) { return around(at) || at.x() > 15; });
}

// A spheroid beside the vessels, and one on a branch: wide vessels go on through it, narrow ones close.
TEST(Planner, AblatesASpheroidAndSparesWideVessels) {
  LiverParts parts = parts_of_ball();
  const Vector3d along = Vector3d(1, 2, -1).normalized();
  const auto zone = [&](const Vector3d& center, double radius_along, double radius_across) {
    return [=](const Vector3d& at) {
      const double a = (at - center).dot(along), b = ((at - center) - a * along).norm();
      return a * a / (radius_along * radius_along) + b * b / (radius_across * radius_across) <= 1;
    };
  };
  const Vector3d beside(5, -25, -12);
  expect_as_judged(parts, {AblationCut{beside, 2 * along, 9, 6}}, zone(beside, 9, 6));

  const Vector3d on_branch(-12, -2.4, 4.8);  // portal/right, 4 mm wide
  const auto ablated = [&] { return Planner::open(parts)->answer({AblationCut{on_branch, along, 5, 5}}).value(); };
  const PlanAnswer spared = ablated();
  EXPECT_TRUE(spared.branches.empty());
  EXPECT_NEAR(*spared.living_ml, spared.remnant_ml, 1e-6);
  EXPECT_NEAR(spared.ablated_ml, spared.removed_ml, 1e-9);
  EXPECT_NEAR(spared.removed_ml, 4.0 / 3 * 3.14159265 * 125 / 1000, 0.02);
  for (auto& point : parts.trees.branches[2].points) point.radius_mm = 1.4;
  const PlanAnswer closed = ablated();
  ASSERT_EQ(closed.branches.size(), 1u);
  EXPECT_EQ(parts.trees.branches[closed.branches.front().branch].name, "portal/right");
  EXPECT_GT(*closed.ischaemic_ml, 1);
}

// A stem that runs along the border of what is taken stays, and so does what it feeds.
TEST(Planner, SparesVesselsThatOnlyRunThroughASegment) {
  LiverParts parts = parts_of_ball();
  // Around the portal stem below, and nothing else.
  for_each_voxel(parts.liver, [&](int i, int j, int k, const Vector3d& at) {
    parts.segments->at(i, j, k) = at.head<2>().norm() < 8 && at.z() < -8 && at.z() > -22 ? 1 : 2;
  });
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner);
  const auto answer = planner->answer({SegmentsCut{{1}}});
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->branches.empty());
  EXPECT_NEAR(*answer->living_ml, answer->remnant_ml, 1e-6);
  // A margin spares nothing: who cuts out a ball there cuts the stem.
  parts.tumours.push_back({"tumour-2", ball_at(parts.liver, {0, 0, -15}, 4)});
  const auto around = Planner::open(parts)->answer({MarginCut{"tumour-2", 2}});
  ASSERT_TRUE(around);
  ASSERT_EQ(around->branches.size(), 1u);
  EXPECT_GT(*around->ischaemic_ml, 0.5 * around->remnant_ml);
}

TEST(Planner, NamesTheBranchesThatAreCut) {
  const auto planner = Planner::open(parts_of_ball());
  ASSERT_TRUE(planner);
  const auto answer = planner->answer({PlaneCut{{10, 0, 0}, {1, 0, 0}, Removed::smaller}});
  ASSERT_TRUE(answer);
  // Two vessels meet the cut; what hangs on one of them is not listed again.
  ASSERT_EQ(answer->branches.size(), 2u);
  std::set<std::string> names;
  for (const CutBranch& cut : answer->branches) {
    names.insert(planner->trees().branches[cut.branch].name);
    EXPECT_NEAR(cut.at_mm.x(), 10.5, 1);
  }
  EXPECT_EQ(names, (std::set<std::string>{"portal/left", "hepatic/left"}));
  EXPECT_NEAR(answer->branches.front().beyond_ml, 80, 25);  // two of the four branches, the stem's tissue apart
}

TEST(Planner, CutsVesselsThatTheOutlineLeavesOut) {
  LiverParts parts = parts_of_ball();
  const auto whole = Planner::open(parts);
  // The lumen is no liver in many outlines.
  for_each_voxel(ball(), [&](int i, int j, int k, const Vector3d& at) {
    for (const System system : {System::portal_vein, System::hepatic_vein}) {
      const Nearest nearest = nearest_vessel(parts.trees, system, at);
      const auto& point = parts.trees.branches[static_cast<std::size_t>(nearest.branch)].points[nearest.point];
      if ((point.position_mm - at).norm() < point.radius_mm) parts.liver.at(i, j, k) = 0;
    }
  });
  const auto hollow = Planner::open(parts);
  ASSERT_TRUE(whole && hollow);
  const PlaneCut cut{{10, 0, 0}, {1, 0, 0}, Removed::smaller};
  EXPECT_EQ(hollow->answer({cut})->branches.size(), whole->answer({cut})->branches.size());
  EXPECT_NEAR(*hollow->answer({cut})->ischaemic_ml, *whole->answer({cut})->ischaemic_ml, 4);
}

TEST(Planner, LeavesOutWhatIsNotKnown) {
  LiverParts parts;
  parts.liver = ball();
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner);
  const auto answer = planner->answer({PlaneCut{{0, 0, 10.75}, {0, 0, 1}, Removed::smaller}});  // between layers
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->ischaemic_ml || answer->drained_ml || answer->margin_mm || answer->left.mean_kPa);
  EXPECT_TRUE(answer->segments.empty());
  EXPECT_NEAR(answer->removed_ml, std::numbers::pi / 3 * 29.25 * 29.25 * (3 * 40 - 29.25) / 1000,
              1);  // the cap of a ball
}

TEST(Planner, RefusesWhatCannotBeCutInASentence) {
  LiverParts parts = parts_of_ball();
  for (std::uint16_t& segment : parts.segments->values) segment = segment == 3 ? 4 : segment;
  parts.trees.branches.push_back(straight(System::portal_vein, -1, {200, 0, 0}, {220, 0, 0}, 1));
  parts.trees.branches.back().name = "portal/elsewhere";
  const auto planner = Planner::open(parts);
  ASSERT_TRUE(planner);
  const auto code = [&](const std::vector<Cut>& cuts) {
    const auto answer = planner->answer(cuts);
    EXPECT_FALSE(answer);
    if (answer) return std::string();
    EXPECT_TRUE(answer.error().message().ends_with("."));
    return answer.error().code;
  };
  EXPECT_EQ(code({}), "plan-empty");
  EXPECT_EQ(code({SegmentsCut{}}), "plan-empty");
  EXPECT_EQ(code({PlaneCut{{0, 0, 300}, {0, 0, 1}, Removed::smaller}}), "cut-misses");
  EXPECT_EQ(code({PlaneCut{{0, 0, 0}, {0, 0, 0}, Removed::smaller}}), "cut-invalid");
  EXPECT_EQ(code({SegmentsCut{{9}}}), "segment-unknown");
  EXPECT_EQ(code({SegmentsCut{{3}}}), "segment-empty");
  EXPECT_EQ(code({TerritoryCut{"portal/nowhere"}}), "branch-unknown");
  EXPECT_EQ(code({TerritoryCut{""}}), "branch-unknown");
  EXPECT_EQ(code({TerritoryCut{"portal/elsewhere"}}), "territory-empty");
  EXPECT_EQ(code({MarginCut{"tumour-9", 5}}), "tumour-unknown");
  EXPECT_EQ(code({MarginCut{"tumour-1", 31}}), "margin-invalid");
  EXPECT_EQ(code({TerritoryCut{"portal"}}), "nothing-left");
  EXPECT_EQ(
      Planner::open({Mask{ball().grid, std::vector<std::uint8_t>(ball().values.size(), 0)}, {}, {}, {}, {}, {}, {}})
          .error()
          .code,
      "liver-empty");
  EXPECT_EQ(Planner::open({ball(), {}, {}, {}, {}, {}, {}})->answer({SegmentsCut{{1}}}).error().code,
            "segments-missing");
}

}  // namespace
}  // namespace glisson::planning
