// Two studies of a generated patient through the program itself: outlines in, segments found in each, growth out. The
// left side of the second liver is drawn out by a known factor.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "imaging/volume_file.h"
#include "support/drawn_out.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class GrowthCommand : public testing::Test {
 protected:
  Json answer(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    const Finished finished = glisson_cli(arguments);
    EXPECT_EQ(finished.exit_code, 0) << arguments.front() << ": " << finished.err;
    return finished.json();
  }
  std::string refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    const Finished finished = glisson_cli(arguments);
    EXPECT_EQ(finished.exit_code, 1);
    return finished.json().at("error").at("code");
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  void make_case(const std::string& name, const imaging::Mask& liver) {
    imaging::Volume scan{{liver.grid, {}}, ""};
    for (const std::uint8_t inside : liver.values) scan.values.push_back(inside != 0 ? 110.0F : 20.0F);
    ASSERT_TRUE(imaging::write_volume_file(file(name + "-scan.nrrd"), scan));
    ASSERT_TRUE(
        imaging::write_mask_file(file(name + "-liver.nrrd"), liver, imaging::SegmentInfo{"liver", 1, {1, 0, 0}}));
    answer({"import", file(name + "-scan.nrrd"), "--case", file(name + ".glisson")});
    answer({"segment", file(name + ".glisson"), "--structure", "liver", "--labels", file(name + "-liver.nrrd")});
  }

  TemporaryFolder folder_;
};

TEST_F(GrowthCommand, TellsWhatGrewBetweenTwoStudies) {
  answer({"study", "anatomy", "--seed", "31", "--label-spacing-mm", "3", "--out", file("anatomy")});
  const imaging::Mask liver = imaging::read_mask_file(file("anatomy/labels/liver.nrrd")).value().mask;
  const DrawnOut growth{liver.grid.position_mm(liver.grid.size[0] / 2, 0, 0).x() + 1.5, 1.4};
  make_case("before", liver);
  make_case("after", growth.carried(liver, growth.other_grid(liver.grid)));
  const std::string before = file("before.glisson"), after = file("after.glisson");

  const auto compare = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"growth", before, after, "--out", file("growth")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  EXPECT_EQ(refused(compare({})), "growth-segments-missing");
  const Json was = answer({"territories", before, "--from", "prior", "--couinaud"}).at("segments");
  EXPECT_EQ(refused(compare({})), "growth-segments-missing");
  const Json is = answer({"territories", after, "--from", "prior", "--couinaud"}).at("segments");
  EXPECT_FALSE(fs::exists(file("growth")));  // nothing was written for what was refused
  ASSERT_TRUE(write_file(file("plan.json"), R"({"name": "Right side", "segments": [5, 6, 7, 8]})"));
  answer({"plan", before, "--add", file("plan.json")});

  const Json grown = answer(compare({"--plan", "Right side", "--days", "28"}));
  EXPECT_EQ(grown.at("format"), "glisson-growth/1");
  EXPECT_EQ(grown.at("days"), 28);
  EXPECT_EQ(grown.at("days_from"), "given");
  double remnant_before_ml = 0, remnant_after_ml = 0, all_before_ml = 0, all_after_ml = 0;
  ASSERT_EQ(grown.at("segments").size(), 8u);
  for (std::size_t s = 0; s < 8; ++s) {
    const Json& segment = grown.at("segments")[s];
    const double was_ml = was[s].at("volume_ml"), is_ml = is[s].at("volume_ml");
    EXPECT_NEAR(segment.at("before_ml"), was_ml, 1e-6);
    EXPECT_NEAR(segment.at("after_ml"), is_ml, 1e-6);
    EXPECT_NEAR(segment.at("change_ml"), is_ml - was_ml, 1e-6);
    EXPECT_NEAR(segment.at("change_percent"), 100 * (is_ml / was_ml - 1), 1e-6);
    const bool within = std::abs(100 * (is_ml / was_ml - 1)) <= grown.at("segment_error_percent").get<double>();
    EXPECT_EQ(segment.at("within_error"), within);
    all_before_ml += was_ml;
    all_after_ml += is_ml;
    if (s < 4) remnant_before_ml += was_ml, remnant_after_ml += is_ml;
  }
  const Json& remnant = grown.at("remnant");
  EXPECT_NEAR(remnant.at("before_ml"), remnant_before_ml, 1e-6);
  EXPECT_NEAR(remnant.at("after_ml"), remnant_after_ml, 1e-6);
  const double points = 100 * (remnant_after_ml / all_after_ml - remnant_before_ml / all_before_ml);
  EXPECT_NEAR(remnant.at("degree_of_hypertrophy_points"), points, 0.05);
  EXPECT_NEAR(remnant.at("kinetic_growth_rate_points_per_week"), points / 4, 0.02);
  // Found again, not only counted again: the whole liver to its voxels, the remnant as far as segments are found.
  double liver_ml = 0;
  for (const std::uint8_t value : liver.values) liver_ml += value != 0 ? liver.grid.voxel_volume_mm3() / 1000 : 0;
  EXPECT_NEAR(grown.at("liver").at("before_ml"), liver_ml, 1e-6);
  EXPECT_GT(remnant.at("change_percent"), 15.0);
  EXPECT_THAT(grown.at("sentences").dump(), HasSubstr("of one patient"));  // NRRD files name nobody

  const auto document = read_json_file(file("growth/growth.json"));
  ASSERT_TRUE(document);
  EXPECT_EQ(document->at("remnant"), remnant);
  const auto table = read_text_file(file("growth/growth.csv"));
  ASSERT_TRUE(table);
  EXPECT_EQ(std::count(table->begin(), table->end(), '\n'), 11);  // a head, eight segments, the remnant, the liver
  EXPECT_THAT(*table, HasSubstr("\nVIII,"));
  const auto page = read_text_file(file("growth/growth.html"));
  ASSERT_TRUE(page);
  EXPECT_THAT(*page, HasSubstr("what the plan Right side leaves"));
  EXPECT_THAT(*page, HasSubstr("segment VIII"));
  EXPECT_THAT(*page, HasSubstr("Kinetic growth rate"));

  const Json standard = answer(compare({"--plan", "Right side", "--standard-liver-ml", "1500"}));
  EXPECT_EQ(standard.at("percent_of"), "standard");
  EXPECT_NEAR(standard.at("remnant").at("degree_of_hypertrophy_points"), (remnant_after_ml - remnant_before_ml) / 15,
              1e-6);
  EXPECT_TRUE(standard.at("remnant").contains("kinetic_growth_rate_reason"));
  const Finished told = glisson_cli(compare({"--plan", "Right side", "--days", "28", "--quiet"}));
  EXPECT_THAT(told.out, HasSubstr("Kinetic growth rate"));

  EXPECT_EQ(refused(compare({"--plan", "Nowhere"})), "plan-unknown");
  EXPECT_EQ(glisson_cli(compare({"--days", "0"})).exit_code, 2);
  EXPECT_EQ(glisson_cli({"growth", before, after}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"growth", before, "--out", file("growth")}).exit_code, 2);
  EXPECT_EQ(refused({"growth", before, before, "--out", file("growth")}), "growth-same-case");
}

}  // namespace
}  // namespace glisson::test
