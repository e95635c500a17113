// A planned resection kept in files, and the cut set again from them.

#include "casefile/resection_folder.h"

#include <gtest/gtest.h>
#include <fstream>

#include "base/files.h"
#include "base/json.h"
#include "casefile/case.h"
#include "casefile/result_folder.h"
#include "geometry/mesh_file.h"
#include "support/shapes.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;

class ResectionFolder : public ::testing::Test {
 protected:
  const geometry::TetMesh liver_ = glisson::test::box_of_tetrahedra({6, 4, 4}, {120, 80, 80});  // 768 ml
  TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path() / "resection";
};

PlannedCut plane_at(double x_mm, PlannedCut::Removed removed = PlannedCut::Removed::smaller) {
  return {{}, {x_mm, 0, 0}, {1, 0, 0}, removed};
}

TEST_F(ResectionFolder, KeepsTheCutAndWhatCameOfIt) {
  const PlannedCut cut = plane_at(90, PlannedCut::Removed::larger);
  const auto plan = plan_resection(liver_, cut, {});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->specimen_ml, 576, 1e-6);  // 90 of 120 mm
  ASSERT_TRUE(write_resection(folder_, cut, *plan));
  const auto json = read_json_file(folder_ / "resection.json");
  ASSERT_TRUE(json);
  EXPECT_NEAR((*json)["remnant_percent"].get<double>(), 25, 1e-6);
  EXPECT_TRUE(fs::exists(folder_ / "parts.vtu"));
  EXPECT_TRUE(fs::exists(folder_ / "cut.vtp"));
  const auto again = read_planned_cut(folder_);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->normal, cut.normal);
  EXPECT_EQ(again->point_mm, cut.point_mm);
  EXPECT_EQ(again->removed, cut.removed);
}

TEST_F(ResectionFolder, GoesWithItsFilesAndNoOthers) {
  ASSERT_TRUE(remove_resection(folder_));  // none there
  ASSERT_TRUE(write_resection(folder_, plane_at(90), *plan_resection(liver_, plane_at(90), {})));
  std::ofstream(folder_ / "notes.txt") << "mine";
  ASSERT_TRUE(remove_resection(folder_));
  EXPECT_FALSE(read_planned_cut(folder_));
  EXPECT_FALSE(fs::exists(folder_ / "parts.vtu"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

// A case from somewhere else, whose results lie elsewhere.
TEST_F(ResectionFolder, OfACaseIsWrittenAndRemovedThroughNoLink) {
  const fs::path patient = temporary_.path() / "patient.glisson", elsewhere = temporary_.path() / "elsewhere";
  ASSERT_TRUE(Case::create(patient));
  ASSERT_TRUE(write_text_file(elsewhere / "resection" / "resection.json", "theirs"));
  fs::create_directory_symlink(elsewhere, patient / "results");
  const fs::path folder = patient / "results" / "resection";
  const auto plan = plan_resection(liver_, plane_at(90), {});
  const auto written = write_resection(folder, plane_at(90), *plan);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "case-link");
  EXPECT_EQ(remove_resection(folder).error().code, "case-link");
  EXPECT_EQ(write_result(patient / "results" / "mre", {}).error().code, "case-link");
  EXPECT_EQ(read_text_file(elsewhere / "resection" / "resection.json").value(), "theirs");
  EXPECT_FALSE(fs::exists(elsewhere / "mre"));
  // Into the place itself, and where no case is, links are a person's own.
  EXPECT_TRUE(write_resection(elsewhere / "resection", plane_at(90), *plan));
  fs::remove(patient / "results");
  EXPECT_TRUE(write_resection(folder, plane_at(90), *plan));
}

TEST_F(ResectionFolder, KeepsThatTheLiverWasHeldAsideAndItsPartsAtRest) {
  PlannedCut cut = plane_at(110);
  cut.liver = PlannedCut::Liver::held_aside;
  const std::vector<Eigen::Vector3d> moved_mm(liver_.points_mm.size(), Eigen::Vector3d(20, 0, 0));
  const auto plan = plan_resection(*rehearsal::displaced(liver_, moved_mm), cut, {});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->specimen_ml, 192, 1e-6);  // 30 of 120 mm: the plane meets what lies at 90 at rest
  ASSERT_TRUE(write_resection(folder_, cut, *plan));
  EXPECT_EQ(read_planned_cut(folder_)->liver, PlannedCut::Liver::held_aside);
  const auto parts = geometry::read_tetrahedra(folder_ / "parts.vtu");
  ASSERT_TRUE(parts);
  EXPECT_NEAR(geometry::bounding_box(parts->points_mm).max_mm.x(), 120, 1e-4);
  EXPECT_NE(geometry::find_field(parts->point_fields, "displacement_mm"), nullptr);
}

TEST_F(ResectionFolder, KeepsAllPointsOfASheet) {
  const PlannedCut cut{{{60, 0, 0}, {70, 80, 0}, {60, 0, 80}, {60, 80, 80}, {55, 40, 40}}, {}, {}, {}};
  const auto plan = plan_resection(liver_, cut, {});
  ASSERT_TRUE(plan);
  ASSERT_TRUE(write_resection(folder_, cut, *plan));
  const auto again = read_planned_cut(folder_);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->through_mm, cut.through_mm);
}

TEST_F(ResectionFolder, TheOtherPartIsTheLargerOne) {
  const auto smaller = plan_resection(liver_, plane_at(30), {});
  const auto larger = plan_resection(liver_, plane_at(30, PlannedCut::Removed::larger), {});
  ASSERT_TRUE(smaller && larger);
  EXPECT_NEAR(smaller->specimen_ml, larger->remnant_ml, 1e-9);
  EXPECT_NE(smaller->specimen_is_above, larger->specimen_is_above);
}

TEST_F(ResectionFolder, ACystHasASideAndNoMargin) {
  const auto cyst =
      rehearsal::NamedStructure{"cyst-2", resection_kind("cyst-2"), glisson::test::sphere_surface(5, 2, {28, 40, 40})};
  const auto plan = plan_resection(liver_, plane_at(30), {cyst});
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->tumours.empty());
  ASSERT_EQ(plan->cysts.size(), 1U);
  EXPECT_EQ(plan->cysts.front().side, rehearsal::ResectionSide::both);
}

TEST_F(ResectionFolder, RefusesAFolderThatHoldsNone) {
  const auto none = read_planned_cut(folder_);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "not-a-resection");
  fs::create_directories(folder_);
  ASSERT_TRUE(write_text_file(folder_ / "resection.json", R"({"cut": {"normal": [1, "x", 0]}})"));
  EXPECT_EQ(read_planned_cut(folder_).error().code, "not-a-resection");
}

}  // namespace
}  // namespace glisson::casefile
