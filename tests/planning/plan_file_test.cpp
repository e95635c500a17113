// Plans as files: what was written comes back, and what cannot be a plan is refused by its place.

#include "planning/plan_file.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"

namespace glisson::planning {
namespace {

class PlanFile : public testing::Test {
 protected:
  Result<Plan> read(const std::string& text) {
    EXPECT_TRUE(write_file(file_, text));
    return read_plan(file_);
  }
  std::string refusal(const std::string& text) {
    const auto plan = read(text);
    EXPECT_FALSE(plan) << text;
    return plan ? "" : plan.error().message();
  }
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "plan.json";
};

TEST_F(PlanFile, ComesBackAsItWasWritten) {
  const Plan plan{
      "right",
      {PlaneCut{{1, 2, 3}, {0, 1, 0}, Removed::larger}, SheetCut{{{0, 0, 0}, {9, 0, 0}, {0, 9, 1}}, Removed::above},
       SegmentsCut{{6, 7}}, TerritoryCut{"portal/right/posterior"}, MarginCut{"tumour-1", 12.5},
       AblationCut{{1, 2, 3}, {0, 0, 1}, 20, 15}}};
  const auto back = read(plan_json(plan).dump());
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(plan_json(*back), plan_json(plan));
  EXPECT_EQ(back->cuts.size(), 6u);
}

TEST_F(PlanFile, OfOneCutNeedsNoList) {
  const auto plan = read(R"({"name": "VI and VII", "segments": [6, 7]})");
  ASSERT_TRUE(plan) << plan.error().message();
  EXPECT_EQ(std::get<SegmentsCut>(plan->cuts.front()).segments, (std::vector<int>{6, 7}));
  EXPECT_TRUE(read(R"({"name": "wedge", "around": "tumour-1", "margin_mm": 10})"));
}

TEST_F(PlanFile, IsRefusedByItsPlace) {
  EXPECT_THAT(refusal(R"({"segments": [6]})"), testing::HasSubstr("name"));
  EXPECT_THAT(refusal(R"({"name": "x"})"), testing::HasSubstr("needs one of plane"));
  EXPECT_THAT(refusal(R"({"name": "x", "cuts": []})"), testing::HasSubstr("at least one cut"));
  EXPECT_THAT(refusal(R"({"name": "x", "cuts": [{"segments": [9]}]})"), testing::HasSubstr("cut 1, segments"));
  EXPECT_THAT(refusal(R"({"name": "x", "cuts": [{"around": "tumour-1"}]})"), testing::HasSubstr("margin_mm"));
  EXPECT_THAT(refusal(R"({"name": "x", "plane": {"point_mm": [0, 0], "normal": [0, 0, 1]}})"),
              testing::HasSubstr("point_mm"));
  EXPECT_THAT(refusal(R"({"name": "x", "ablation": {"center_mm": [0, 0, 0], "direction": [0, 0, 1]}})"),
              testing::HasSubstr("radius_along_mm"));
  EXPECT_THAT(refusal(R"({"name": "x", "plain": 3})"), testing::HasSubstr("plain"));
  EXPECT_THAT(refusal(R"([])"), testing::HasSubstr("object"));
}

}  // namespace
}  // namespace glisson::planning
