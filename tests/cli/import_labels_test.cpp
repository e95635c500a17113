// Images with the label maps of other programs become a case, and nobody else's images slip into one.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/files.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class ImportLabels : public testing::Test {
 protected:
  void SetUp() override {
    GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
    GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  }
  // A folder with copies of these, as somebody would keep them together.
  fs::path folder_of(const std::vector<std::string>& files, const std::string& name = "study") const {
    const fs::path folder = temporary_.path() / name;
    fs::create_directories(folder);
    for (const std::string& file : files) {
      fs::copy(data() / file, folder / fs::path(file).filename(), fs::copy_options::recursive);
    }
    return folder;
  }
  static fs::path data() { return shared_data() / "totalseg_abdomen_mr_ct"; }
  static fs::path slices() { return shared_data() / "dcmqi_liver_seg_ct3" / "ct-3slice"; }
  std::string file(const std::string& name) const { return (temporary_.path() / name).string(); }
  static Finished import(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "import");
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    return glisson_cli(arguments);
  }
  static double volume_ml(const Json& imported, const std::string& structure) {
    for (const Json& label : imported.at("labels")) {
      if (label.at("structure") == structure) return label.at("volume_ml").get<double>();
    }
    return 0;
  }
  static std::string notes(const Json& imported) { return imported.at("labels").dump(); }

  TemporaryFolder temporary_;
};

// Volumes are counts of voxels times 27 mm3, counted in the file by other means.
TEST_F(ImportLabels, ATotalSegmentatorMapComesInByTheNamesThatItCarries) {
  const fs::path folder = folder_of({"example_ct_sm.nii.gz", "example_seg.nii.gz"});
  const Finished done = import({folder.string(), "--case", file("ct.glisson")});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json imported = done.json();
  EXPECT_NEAR(volume_ml(imported, "liver"), 38634 * 0.027, 1e-6);
  EXPECT_NEAR(volume_ml(imported, "portal-vein"), 901 * 0.027, 1e-6);
  EXPECT_NEAR(volume_ml(imported, "vena-cava"), 1368 * 0.027, 1e-6);
  EXPECT_NEAR(volume_ml(imported, "kidney-left"), 3676 * 0.027, 1e-6);
  EXPECT_THAT(imported.at("structures").get<std::vector<std::string>>(), Not(Contains(HasSubstr("vertebrae"))));
  EXPECT_THAT(notes(imported), HasSubstr("vertebrae_L2"));  // said to be left out
  EXPECT_THAT(notes(imported), Not(HasSubstr("another grid")));
}

// Of two tables of classes the file says which: 24 is a vena cava in MR, and a kidney's cyst in CT.
TEST_F(ImportLabels, TheTableForMrIsNotThatForCt) {
  const fs::path folder = folder_of({"example_mr_sm.nii.gz", "example_seg_mr.nii.gz"});
  const Finished done = import({folder.string(), "--case", file("mr.glisson")});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NEAR(volume_ml(done.json(), "vena-cava"), 444 * 0.027, 1e-3);
  EXPECT_NEAR(volume_ml(done.json(), "liver"), 18480 * 0.027, 1e-2);
}

TEST_F(ImportLabels, LabelsOfANiftiLieOnTheDicomSeriesThatTheyWereDrawnOn) {
  const Json scan = glisson_cli({"scan", (data() / "example_ct_dicom").string(), "--json", "--quiet"}).json();
  const Finished done = import({data().string(), "--case", file("dicom.glisson"), "--anatomy",
                                scan.at("series")[0].at("uid").get<std::string>()});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.json().at("labels").dump(), Not(HasSubstr("\"kidney-left\"")));  // the other examples' maps stay out
  const double voxel_ml = done.json().at("volumes")[0].at("spacing_mm")[0].get<double>() *
                          done.json().at("volumes")[0].at("spacing_mm")[1].get<double>() * 2e-3;
  EXPECT_NEAR(volume_ml(done.json(), "liver"), 366708 * voxel_ml, 1e-3 * 366708 * voxel_ml);
}

TEST_F(ImportLabels, AMapOnAnotherGridIsCarriedOverAndThatIsSaid) {
  const fs::path folder = folder_of({"example_ct.nii.gz", "example_seg_dicom.nii.gz", "example_seg.nii.gz"});
  const Finished done =
      import({folder.string(), "--case", file("whole.glisson"), "--labels", (folder / "example_seg.nii.gz").string()});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NEAR(volume_ml(done.json(), "liver"), 38634 * 0.027, 1e-6);  // of the slab that it was drawn in
  EXPECT_THAT(notes(done.json()), HasSubstr("another grid (122 x 101 x 30)"));
}

TEST_F(ImportLabels, AMaskIsNamedAfterItsFileAndElseByThePerson) {
  const fs::path folder = temporary_.path() / "masked";
  fs::copy(slices(), folder, fs::copy_options::recursive);
  fs::copy(shared_data() / "dcmqi_liver_seg_ct3" / "liver_seg.nrrd", folder / "liver_seg.nrrd");
  const Finished named = import({folder.string(), "--case", file("named.glisson")});
  ASSERT_EQ(named.exit_code, 0) << named.err;
  const double liver_ml = volume_ml(named.json(), "liver");
  EXPECT_GT(liver_ml, 1);

  fs::rename(folder / "liver_seg.nrrd", folder / "somebody_seg.nrrd");
  const Finished refused = import({folder.string(), "--case", file("unnamed.glisson")});
  EXPECT_EQ(refused.exit_code, 1);
  const Json error = refused.json().at("error");
  EXPECT_EQ(error.at("code"), "labels-unnamed");
  EXPECT_THAT(error.at("message").get<std::string>(), HasSubstr("1 ("));
  EXPECT_THAT(error.at("hint").get<std::string>(), HasSubstr("--label-value 1=liver"));
  EXPECT_FALSE(fs::exists(file("unnamed.glisson")));
  const Finished given = import({folder.string(), "--case", file("given.glisson"), "--label-value", "1=Segment IV"});
  ASSERT_EQ(given.exit_code, 0) << given.err;
  EXPECT_NEAR(volume_ml(given.json(), "segment-iv"), liver_ml, 1e-9);
  EXPECT_EQ(import({folder.string(), "--case", file("x.glisson"), "--label-value", "liver"}).exit_code, 2);
  EXPECT_EQ(
      import({folder.string(), "--case", file("x.glisson"), "--label-value", "9=liver"}).json().at("error").at("code"),
      "labels-no-such-value");
}

TEST_F(ImportLabels, LabelsAreAddedToACaseThatIsThere) {
  const std::string patient = file("later.glisson");
  ASSERT_EQ(import({(data() / "example_ct_sm.nii.gz").string(), "--case", patient}).exit_code, 0);
  const Finished added = import({(data() / "example_seg_fast" / "liver.nii.gz").string(), "--case", patient, "--add"});
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NEAR(volume_ml(added.json(), "liver"), 39350 * 0.027, 1e-6);
  EXPECT_TRUE(fs::exists(fs::path(patient) / "labels" / "liver.nrrd"));
  EXPECT_TRUE(added.json().at("volumes").empty());
}

TEST_F(ImportLabels, AnotherPatientsImagesAreRefusedAndTheCaseStaysAsItWas) {
  const std::string patient = file("hers.glisson");
  ASSERT_EQ(import({slices().string(), "--case", patient}).exit_code, 0);
  const std::string before = read_text_file(fs::path(patient) / "case.json").value();
  EXPECT_THAT(before, HasSubstr("whose-patient"));
  for (const char* clear : {"JANCT000", "99000"}) EXPECT_THAT(before, Not(HasSubstr(clear)));

  const std::string others = (data() / "example_ct_dicom").string();
  const Finished refused = import({others, "--case", patient, "--add"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.json().at("error").at("code"), "import-not-this-patient");
  EXPECT_THAT(refused.json().at("error").at("message").get<std::string>(), HasSubstr("frame of reference"));
  EXPECT_THAT(refused.json().at("error").at("hint").get<std::string>(), HasSubstr("--replace"));
  EXPECT_EQ(read_text_file(fs::path(patient) / "case.json").value(), before);
  const Finished again = import({slices().string(), "--case", patient, "--add"});  // the same, and it is there already
  EXPECT_EQ(again.json().at("error").at("code"), "import-would-replace");
  const Finished elsewhere = import({(data() / "example_mr_sm.nii.gz").string(), "--case", patient, "--add"});
  EXPECT_EQ(elsewhere.json().at("error").at("code"), "import-not-this-patient");
  EXPECT_EQ(read_text_file(fs::path(patient) / "case.json").value(), before);

  const Finished replaced = import({others, "--case", patient, "--replace"});
  ASSERT_EQ(replaced.exit_code, 0) << replaced.err;
  EXPECT_EQ(replaced.json().at("volumes")[0].at("size")[2], 20);
}

}  // namespace
}  // namespace glisson::test
