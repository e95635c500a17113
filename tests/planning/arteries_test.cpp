// Arteries and bile ducts in a plan: which a cut crosses and how much of them lies beyond it, worked out by hand on
// straight lines; and that nothing else in the answer changes for them.

#include <gmock/gmock.h>

#include "base/json.h"
#include "planning/parts_of_a_ball.h"
#include "planning/plan_file.h"
#include "vasculature/ucl_patient.h"

namespace glisson::planning {
namespace {

using Eigen::Vector3d;
using vasculature::System;

const Vector3d far_end(25, 7, 15), turned_back(0, 27, 20);

// An artery that enters from below and divides, a branch of which turns back over x = 10; a duct that only passes.
LiverParts with_arteries() {
  LiverParts parts = parts_of_ball();
  const int first = static_cast<int>(parts.trees.branches.size());
  const auto add = [&](System system, int parent, const Vector3d& from, const Vector3d& to, const char* name) {
    parts.trees.branches.push_back(vasculature::straight(system, parent, from, to, 1));
    parts.trees.branches.back().name = name;
  };
  add(System::artery, -1, {-2, 2, -60}, {-2, 2, 0}, "hepatic-artery/stem");
  add(System::artery, first, {-2, 2, 0}, far_end, "hepatic-artery/left");
  add(System::artery, first, {-2, 2, 0}, {-25, -3, 10}, "hepatic-artery/right");
  add(System::artery, first + 1, far_end, turned_back, "hepatic-artery/left/lateral/II");
  add(System::biliary_tract, -1, {10, -20, -10}, {-20, -20, -10}, "bile-duct/right");
  return parts;
}

Planner planner_of(const LiverParts& parts) { return Planner::open(parts).value(); }

const CutBranch* cut_of(const PlanAnswer& answer, const Planner& planner, const std::string& name) {
  for (const CutBranch& cut : answer.branches) {
    if (planner.trees().branches[cut.branch].name == name) return &cut;
  }
  return nullptr;
}

const std::vector<Cut> beyond_ten{PlaneCut{{10, 0, 0}, {1, 0, 0}, Removed::above}};

TEST(Arteries, ACutTellsWhichItCrossesAndHowMuchLiesBeyond) {
  const Planner planner = planner_of(with_arteries());
  const PlanAnswer answer = planner.answer(beyond_ten).value();
  const CutBranch* left = cut_of(answer, planner, "hepatic-artery/left");
  ASSERT_NE(left, nullptr);
  EXPECT_NEAR(left->at_mm.x(), 10, 1);
  EXPECT_DOUBLE_EQ(left->radius_mm, 1);
  const double outwards_mm = 15.0 / 27 * (far_end - Vector3d(-2, 2, 0)).norm();
  const double back_mm = (turned_back - far_end).norm();
  EXPECT_NEAR(left->beyond_mm, outwards_mm + back_mm, 1.5);
  EXPECT_NEAR(left->left_mm, 10.0 / 25 * back_mm, 1.5) << "what turns back runs on in what stays";
  EXPECT_EQ(left->beyond_ml, 0);
  EXPECT_EQ(cut_of(answer, planner, "hepatic-artery/left/lateral/II"), nullptr) << "it hangs on what is cut";
  EXPECT_EQ(cut_of(answer, planner, "hepatic-artery/stem"), nullptr);
  EXPECT_EQ(cut_of(answer, planner, "hepatic-artery/right"), nullptr);

  const auto told = beyond_cut(*left, System::artery);
  ASSERT_TRUE(told);
  EXPECT_STREQ(told->unit, "mm");
  EXPECT_DOUBLE_EQ(told->left, left->left_mm);
  const Json document = answer_json(answer, planner.trees());
  for (const Json& branch : document.at("branches")) {
    if (branch.at("name") != "hepatic-artery/left") continue;
    EXPECT_EQ(branch.at("system"), "artery");
    EXPECT_DOUBLE_EQ(beyond_cut(branch)->beyond, left->beyond_mm);
  }
}

TEST(Arteries, ChangeNothingElse) {
  const Planner with = planner_of(with_arteries()), without = planner_of(parts_of_ball());
  for (const std::vector<Cut>& cuts : {beyond_ten,
                                       {SegmentsCut{{1, 3}}},
                                       {TerritoryCut{"hepatic/left"}},
                                       {TerritoryCut{"portal/left"}, MarginCut{"tumour-1", 5}}}) {
    const PlanAnswer a = with.answer(cuts).value(), b = without.answer(cuts).value();
    EXPECT_EQ(a.removed_ml, b.removed_ml);
    EXPECT_EQ(a.ischaemic_ml, b.ischaemic_ml);
    EXPECT_EQ(a.congested_ml, b.congested_ml);
    EXPECT_EQ(a.living_ml, b.living_ml);
    EXPECT_EQ(a.margin_mm, b.margin_mm);
    std::vector<CutBranch> veins;
    std::copy_if(a.branches.begin(), a.branches.end(), std::back_inserter(veins),
                 [&](const CutBranch& cut) { return vasculature::is_vein(with.trees().branches[cut.branch].system); });
    ASSERT_EQ(veins.size(), b.branches.size());
    for (std::size_t n = 0; n < veins.size(); ++n) {
      EXPECT_EQ(veins[n].branch, b.branches[n].branch);
      EXPECT_EQ(veins[n].beyond_ml, b.branches[n].beyond_ml);
      EXPECT_EQ(veins[n].beyond_mm, b.branches[n].beyond_mm);
    }
  }
}

// Of the duct's 30 mm a third runs in segment 2, in which it begins.
TEST(Arteries, ACutAlongSegmentsSparesADuctThatOnlyPasses) {
  const Planner planner = planner_of(with_arteries());
  const PlanAnswer along = planner.answer({SegmentsCut{{2}}}).value();
  EXPECT_EQ(cut_of(along, planner, "bile-duct/right"), nullptr);
  const PlanAnswer plane = planner.answer({PlaneCut{{5, 0, 0}, {1, 0, 0}, Removed::above}}).value();
  const CutBranch* duct = cut_of(plane, planner, "bile-duct/right");
  ASSERT_NE(duct, nullptr);
  EXPECT_NEAR(duct->left_mm, 25, 1.5);
  const PlanAnswer left = planner.answer({SegmentsCut{{2, 4, 6, 8}}}).value();  // x > 0
  EXPECT_NE(cut_of(left, planner, "hepatic-artery/left"), nullptr);
  EXPECT_EQ(cut_of(left, planner, "bile-duct/right"), nullptr);
}

TEST(Arteries, HaveNoTerritory) {
  const Planner planner = planner_of(with_arteries());
  const auto answer = planner.answer({TerritoryCut{"hepatic-artery/left"}});
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, "territory-empty");
  EXPECT_THAT(answer.error().message(), testing::HasSubstr("hepatic-artery/left has no tissue of its own"));
}

TEST(Arteries, StandOnTheUnrolledCut) {
  const Planner planner = planner_of(with_arteries());
  const auto map = planner.answer_unrolled(beyond_ten).value().resectograms.front();
  const auto artery = std::find_if(map.vessels.begin(), map.vessels.end(),
                                   [](const auto& vessel) { return vessel.system == System::artery; });
  ASSERT_NE(artery, map.vessels.end());
  EXPECT_EQ(artery->name, "hepatic-artery/left");
}

// Through the hilum's middle, the right side goes: its artery is cut where it divides in the hilum, outside of the
// outline, and that of the left side is not.
TEST(Arteries, APatientsRightHepaticArteryIsCutAtTheHilum) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const test::UclPatient patient = test::ucl_patient();
  LiverParts parts;
  parts.liver = patient.liver;
  parts.trees = patient.all;
  parts.segments = patient.segments.segment;
  parts.portal = territory(patient.all, System::portal_vein, patient.liver);
  parts.hepatic = territory(patient.all, System::hepatic_vein, patient.liver);
  const Planner planner = planner_of(parts);
  const std::vector<Cut> right{PlaneCut{{-60, -190, -290}, {-1, 0, 0}, Removed::above}};
  const PlanAnswer answer = planner.answer(right).value();
  const CutBranch* artery = cut_of(answer, planner, "hepatic-artery/right");
  ASSERT_NE(artery, nullptr);
  EXPECT_NEAR(2 * artery->radius_mm, 3, 1.5);
  EXPECT_NEAR(artery->at_mm.x(), -60, 15) << "the tissue beside it goes";
  EXPECT_GT(artery->beyond_mm, 20);
  for (const CutBranch& cut : answer.branches) {
    const vasculature::TreeBranch& branch = planner.trees().branches[cut.branch];
    if (branch.system != System::artery) continue;
    EXPECT_EQ(branch.name.find("/stem"), std::string::npos) << branch.name;
  }
  LiverParts of_veins = parts;
  of_veins.trees = patient.veins;
  const PlanAnswer before = planner_of(of_veins).answer(right).value();
  EXPECT_EQ(answer.living_ml, before.living_ml);
  EXPECT_EQ(answer.ischaemic_ml, before.ischaemic_ml);
}

}  // namespace
}  // namespace glisson::planning
