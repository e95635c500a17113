// Structures made on a real CT from the command line: grown, by grey values, and one by another.

#include <gmock/gmock.h>

#include "base/files.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

using testing::HasSubstr;

class Segment : public testing::Test {
 protected:
  void SetUp() override {
    GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
    const Finished imported =
        glisson_cli({"import", (data() / "example_ct_dicom").string(), "--case", patient(), "--json", "--quiet"});
    ASSERT_EQ(imported.exit_code, 0) << imported.err;
    const Json liver =
        segment("liver", {"--labels", (data() / "example_seg_dicom.nii.gz").string(), "--label-value", "5"});
    liver_ml_ = liver.at("volume_ml").get<double>();
  }
  static std::filesystem::path data() { return shared_data() / "totalseg_abdomen_mr_ct"; }
  std::string patient() const { return (temporary_.path() / "ct.glisson").string(); }
  Finished run(const std::string& structure, const std::vector<std::string>& how) const {
    std::vector<std::string> arguments{"segment", patient(), "--structure", structure, "--json", "--quiet"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    return glisson_cli(arguments);
  }
  Json segment(const std::string& structure, const std::vector<std::string>& how) const {
    const Finished done = run(structure, how);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.json();
  }

  TemporaryFolder temporary_;
  double liver_ml_ = 0;
};

const char* const in_the_portal_vein = "-53.2,-179.7,-788.5";

TEST_F(Segment, AVesselIsGrownInsideOfTheLiverAndTakenOutOfIt) {
  const double everywhere_ml = segment("portal-vein", {"--seed", in_the_portal_vein}).at("volume_ml").get<double>();
  EXPECT_GT(everywhere_ml, 3);
  EXPECT_LT(everywhere_ml, 15);
  const double inside_ml = segment("vein-inside", {"--unite", "portal-vein"}).at("volume_ml").get<double>();
  EXPECT_DOUBLE_EQ(inside_ml, everywhere_ml);
  const double shared_ml = segment("vein-inside", {"--intersect", "liver"}).at("volume_ml").get<double>();
  EXPECT_GT(shared_ml, 0.5);
  EXPECT_LT(shared_ml, everywhere_ml);
  const double left_ml = segment("liver", {"--subtract", "portal-vein"}).at("volume_ml").get<double>();
  EXPECT_NEAR(left_ml, liver_ml_ - shared_ml, 1e-6);
}

TEST_F(Segment, GreyValuesAreTakenInsideOfAStructure) {
  const double bright_ml =
      segment("vessels", {"--range", "125,300", "--inside", "liver"}).at("volume_ml").get<double>();
  EXPECT_GT(bright_ml, 2);
  EXPECT_LT(bright_ml, 0.3 * liver_ml_);
  EXPECT_NEAR(segment("all", {"--range", "-2000,4000", "--inside", "liver"}).at("volume_ml").get<double>(), liver_ml_,
              1e-6);
  const Finished none = run("nothing", {"--range", "5000,6000"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("grey value"));
}

TEST_F(Segment, WhatCannotBeIsSaid) {
  EXPECT_THAT(run("tumour-1", {"--range", "0,50", "--inside", "spleen"}).err, HasSubstr("spleen"));
  EXPECT_EQ(run("tumour-1", {"--range", "50,0"}).exit_code, 2);
  EXPECT_EQ(run("tumour-1", {}).exit_code, 2);
  EXPECT_EQ(run("liver", {"--unite", "liver", "--subtract", "liver"}).exit_code, 2);
}

}  // namespace
}  // namespace glisson::test
