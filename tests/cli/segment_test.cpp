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
const char* const in_the_liver = "-110,-170,-785";

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

TEST_F(Segment, VesselsAreFoundByTheirShapeAndThoseOfASeedAreSome) {
  const Json all = segment("vessels", {"--tubes"});
  EXPECT_GT(all.at("volume_ml").get<double>(), 3);
  EXPECT_LT(all.at("volume_ml").get<double>(), 0.05 * liver_ml_);
  EXPECT_THAT(all.at("notes").at(0).get<std::string>(), HasSubstr("brighter"));
  const Finished far = run("one", {"--tubes", "--seed", in_the_portal_vein});
  EXPECT_EQ(far.exit_code, 1);  // there the outline of the liver leaves the vein out
  EXPECT_THAT(far.err, HasSubstr("5 mm from every vessel"));
  EXPECT_EQ(run("one", {"--tubes", "--range", "100,200"}).exit_code, 2);
  EXPECT_EQ(run("one", {"--brightness", "dark", "--seed", in_the_portal_vein}).exit_code, 2);
  EXPECT_THAT(run("one", {"--tubes", "--inside", "spleen"}).err, HasSubstr("spleen"));
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

// The network's outline judges what is found without a point. A click takes off what lies around it, and nothing else.
TEST_F(Segment, ALiverIsFoundWithoutAPointAndAClickTakesOffWhatIsNotIt) {
  segment("by-network", {"--unite", "liver"});
  const double found_ml = segment("liver", {}).at("volume_ml").get<double>();
  segment("found", {"--unite", "liver"});
  const double both_ml = segment("by-network", {"--intersect", "found"}).at("volume_ml").get<double>();
  EXPECT_GT(2 * both_ml / (found_ml + liver_ml_), 0.9);

  const double left_ml = segment("liver", {"--not", in_the_liver}).at("volume_ml").get<double>();
  EXPECT_LT(left_ml, found_ml - 1);
  EXPECT_GT(left_ml, 0.5 * found_ml);
  EXPECT_DOUBLE_EQ(segment("found", {"--intersect", "liver"}).at("volume_ml").get<double>(), left_ml);
}

TEST_F(Segment, AClickOnWhatIsNotLiverIsOfTheLiverAndInTheImage) {
  const Finished outside = run("liver", {"--seed", in_the_liver, "--not", "0,0,0"});
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_THAT(outside.err, HasSubstr("Point 1 on what is not liver, at (0.0, 0.0, 0.0) mm, lies 765.5 mm outside"));
  EXPECT_THAT(run("liver", {"--seed", "0,0,0", "--not", in_the_liver}).err, HasSubstr("Seed 1 at (0.0, 0.0, 0.0) mm"));
  EXPECT_EQ(run("spleen", {"--not", in_the_liver}).exit_code, 2);
  EXPECT_EQ(run("liver", {"--not", in_the_liver, "--tubes"}).exit_code, 2);
  EXPECT_THAT(run("liver", {"--not", "1,2"}).err, HasSubstr("--not"));
}

// TotalSegmentator's own map of this CT, as it would write it: its names and volumes come in, whatever had the names.
TEST_F(Segment, WhatAnotherProgramOutlinesComesInByItsNames) {
  const std::string map = (data() / "example_seg_dicom.nii.gz").string();
  const Finished done = glisson_cli({"segment", patient(), "--with",
                                     "sh -c 'test -s \"$1\" && cp " + map + " \"$2\"' network {image} {folder}",
                                     "--named", "5=liver", "--named", "1=spleen", "--json", "--quiet"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  double liver_ml = 0;
  const Json answer = done.json();
  for (const Json& structure : answer.at("structures")) {
    if (structure.at("structure") == "liver") liver_ml = structure.at("volume_ml").get<double>();
  }
  EXPECT_DOUBLE_EQ(liver_ml, liver_ml_);
  const Finished absent = glisson_cli({"segment", patient(), "--with", "no-such-network {image} {folder}"});
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_THAT(absent.err, HasSubstr("There is no program no-such-network on this computer."));
  EXPECT_EQ(glisson_cli({"segment", patient(), "--with", "true {image} {folder}", "--structure", "liver"}).exit_code,
            2);
  EXPECT_EQ(glisson_cli({"segment", patient(), "--with", "true {image} {folder}", "--named", "liver"}).exit_code, 2);
}

TEST_F(Segment, WhatCannotBeIsSaid) {
  EXPECT_THAT(run("tumour-1", {"--range", "0,50", "--inside", "spleen"}).err, HasSubstr("spleen"));
  EXPECT_EQ(run("tumour-1", {"--range", "50,0"}).exit_code, 2);
  EXPECT_EQ(run("tumour-1", {}).exit_code, 2);
  EXPECT_EQ(run("liver", {"--unite", "liver", "--subtract", "liver"}).exit_code, 2);
}

}  // namespace
}  // namespace glisson::test
