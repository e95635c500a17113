// The way from real images to a moved liver, through the program itself.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>

#include "answer.h"
#include "base/files.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Scan, KnowsARealMouse) {
  GLISSON_NEEDS_DATA("mouse_abdomen_mr_dicom");
  const Json scan = answer({"scan", (shared_data() / "mouse_abdomen_mr_dicom").string()});
  // SOURCE.txt of the data: one series, 36 slices of 960 x 320, 0.1667 mm pixels, 0.5 mm slices.
  ASSERT_EQ(scan.at("series").size(), 1u);
  const Json& series = scan.at("series")[0];
  EXPECT_EQ(series.at("modality"), "MR");
  EXPECT_EQ(series.at("files"), 36);
  EXPECT_EQ(series.at("size")[2], 36);
  EXPECT_NEAR(series.at("spacing_mm")[0].get<double>(), 0.1667, 1e-3);
  EXPECT_NEAR(series.at("spacing_mm")[2].get<double>(), 0.5, 1e-3);
  EXPECT_EQ(scan.at("skipped").size(), 1u);  // SOURCE.txt itself
}

TEST(Scan, TellsASegmentationFromItsImages) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const Json scan = answer({"scan", (shared_data() / "dcmqi_liver_seg_ct3").string()});
  std::vector<std::string> roles;
  for (const Json& series : scan.at("series")) roles.push_back(series.at("role"));
  EXPECT_THAT(roles, testing::Contains("segmentation"));
  EXPECT_THAT(roles, testing::Contains("anatomy"));
}

// The slab of a human liver from MR, with labels made by a network: a whole chain on one measured geometry.
class HumanLiver : public testing::Test {
 protected:
  void SetUp() override {
    GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
    const fs::path data = shared_data() / "totalseg_abdomen_mr_ct";
    answer({"import", (data / "example_mr_sm.nii.gz").string(), "--case", case_});
    labels_ = (data / "example_seg_mr.nii.gz").string();
  }

  TemporaryFolder folder_;
  std::string case_ = (folder_.path() / "human.glisson").string();
  std::string labels_;
};

TEST_F(HumanLiver, GoesFromLabelsToAMovedLandmark) {
  const Json liver = answer({"segment", case_, "--structure", "liver", "--labels", labels_, "--label-value", "5"});
  EXPECT_NEAR(liver.at("volume_ml").get<double>(), 499, 1.0);  // SOURCE.txt of the data

  const Json mesh = answer({"mesh", case_, "--target-cells", "8000"});
  EXPECT_TRUE(mesh.at("watertight").get<bool>());
  // The slab cuts 22.7 ml of the left lobe off from the rest; the larger part is meshed, and the notes say so.
  EXPECT_NEAR(mesh.at("volume_ml").get<double>(), 499 - 22.7, 0.03 * 499);
  EXPECT_THAT(mesh.at("notes").dump(), HasSubstr("22.7 ml"));
  EXPECT_GT(mesh.at("min_dihedral_deg").get<double>(), 5.0);

  const Json stiffness = answer({"stiffness", case_, "--uniform-kPa", "6.1"});
  EXPECT_NEAR(stiffness.at("mean_kPa").get<double>(), 6.1, 1e-9);
  EXPECT_EQ(stiffness.at("cells_without_data"), 0);

  // What can be worn for it: its own volume and stiffness are taken over.
  const Json plan = answer({"platform", "plan", case_, "--accuracy-mm", "8"});
  EXPECT_NEAR(plan.at("case").at("youngs_kPa").get<double>(), 6.1, 1e-6);
  EXPECT_NEAR(plan.at("case").at("volume_cm3").get<double>(), mesh.at("volume_ml").get<double>(), 0.1);

  // The slab is held in its front part and hangs under gravity.
  ASSERT_TRUE(write_text_file(folder_.path() / "hold.json", R"({"engine": "fem", "material": "linear",
      "supports": [{"box": {"min_mm": [-1000, -1000, -1000], "max_mm": [1000, 20, 1000]}}],
      "loads": [{"gravity_m_s2": [0, 0, -9.81]}]})"));
  const std::string scenario = (folder_.path() / "hold.json").string();
  const std::string a = (folder_.path() / "a").string();
  const Json result = answer({"simulate", case_, "--scenario", scenario, "--out", a});
  EXPECT_TRUE(result.at("converged").get<bool>());
  EXPECT_LT(result.at("relative_residual").get<double>(), 1e-8);
  EXPECT_GT(result.at("max_displacement_mm").get<double>(), 0.0);
  EXPECT_TRUE(fs::exists(fs::path(a) / "result.vtu"));

  // In linear elasticity half the stiffness moves twice as far.
  answer({"stiffness", case_, "--uniform-kPa", "3.05"});
  const std::string b = (folder_.path() / "b").string();
  answer({"simulate", case_, "--scenario", scenario, "--out", b});
  const Json comparison = answer({"compare", a, b});
  EXPECT_NEAR(comparison.at("max_mm").get<double>(), result.at("max_displacement_mm").get<double>(),
              1e-3 * result.at("max_displacement_mm").get<double>());
}

TEST_F(HumanLiver, AsksForWhatIsMissingInsteadOfGuessing) {
  EXPECT_THAT(glisson_cli({"mesh", case_, "--quiet"}).err, HasSubstr("Segment it first"));
  // The map names its values: the liver is found in it by name, and a tumour is not.
  const Finished several = glisson_cli({"segment", case_, "--structure", "tumour-1", "--labels", labels_, "--quiet"});
  EXPECT_EQ(several.exit_code, 1);
  EXPECT_THAT(several.err, HasSubstr("--label-value"));
  answer({"segment", case_, "--structure", "liver", "--labels", labels_, "--label-value", "5"});
  answer({"mesh", case_, "--target-cells", "2000"});
  const Finished no_mre = glisson_cli({"stiffness", case_, "--quiet"});
  EXPECT_EQ(no_mre.exit_code, 1);
  EXPECT_THAT(no_mre.err, HasSubstr("--uniform-kPa"));
}

TEST_F(HumanLiver, AMisspeltScenarioIsRefusedWithTheWordThatWasMeant) {
  ASSERT_TRUE(write_text_file(folder_.path() / "s.json", R"({"engine": "fem", "suports": []})"));
  const Finished refused = glisson_cli({"simulate", case_, "--scenario", (folder_.path() / "s.json").string(), "--out",
                                        (folder_.path() / "r").string(), "--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("supports"));
  EXPECT_FALSE(fs::exists(folder_.path() / "r"));
}

}  // namespace
}  // namespace glisson::test
