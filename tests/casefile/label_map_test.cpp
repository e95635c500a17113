// What the values of label maps are called, and whose images a case takes for its own.

#include "casefile/label_map.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "casefile/import.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "imaging/label_names.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

// A label map as text: 4 x 3 x 2 voxels with the values 0 to 3, and whatever else its header says.
fs::path text_map(const fs::path& file, const std::string& fields) {
  const std::string text =
      "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 3 2\n"
      "space directions: (2,0,0) (0,2,0) (0,0,5)\nkinds: domain domain domain\nencoding: text\n"
      "space origin: (0,0,0)\n" +
      fields + "\n0 1 1 2\n0 1 1 2\n0 0 0 2\n0 1 3 2\n0 1 3 2\n0 0 0 2\n";
  EXPECT_TRUE(write_text_file(file, text));
  return file;
}
std::map<int, std::string> structures_of(const ReadLabelMap& map) {
  std::map<int, std::string> structures;
  for (const LabelledPart& part : map.parts) structures[part.value] = part.structure;
  return structures;
}

using Names = std::map<int, std::string>;

TEST(LabelMapTest, SlicersSegmentsNameTheirValues) {
  const TemporaryFolder folder;
  const auto map = read_label_map(text_map(folder.path() / "case.seg.nrrd",
                                           "Segment0_ID:=a\nSegment0_Name:=Liver\nSegment0_LabelValue:=1\n"
                                           "Segment1_Name:=Portal veins\nSegment1_LabelValue:=3\n"
                                           "Segment10_Name:=Segment_2\nSegment10_LabelValue:=2\n"));
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(structures_of(*map), (Names{{1, "liver"}, {2, ""}, {3, "portal-vein"}}));  // "Segment_2" is no name
  EXPECT_THAT(map->named_by.message(), HasSubstr("3D Slicer"));
  EXPECT_NEAR(map->parts[0].volume_ml, 6 * 0.020, 1e-12);
  EXPECT_EQ(mask_of(*map, "portal-vein").values[14], 1);
}

TEST(LabelMapTest, ADescriptionOfItkSnapBesideTheMapNamesIt) {
  const TemporaryFolder folder;
  const fs::path map = text_map(folder.path() / "somebody.nrrd", "");
  EXPECT_TRUE(read_label_map(map)->named_by.text.empty());
  ASSERT_TRUE(write_text_file(folder.path() / "labels.txt",
                              "# ITK-SnAP Label Description File\n# IDX -R- -G- -B- -A-- VIS MSH LABEL\n"
                              "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                              "    1   255    0    0        1  1  1    \"liver\"\n"
                              "    2     0  255    0        1  1  1    \"Label 2\"\n"
                              "    3     0    0  255      0.5  1  1    \"liver tumour 2\"\n"));
  const auto read = read_label_map(map);
  EXPECT_EQ(structures_of(*read), (Names{{1, "liver"}, {2, ""}, {3, "tumour-2"}}));
  EXPECT_THAT(read->named_by.message(), HasSubstr("description"));
  EXPECT_FALSE(imaging::label_descriptions("a note about the patient\n"));
  EXPECT_FALSE(imaging::label_descriptions("1 255 0 0 1 1 1 liver\n"));
}

TEST(LabelMapTest, WhatThePersonSaysStandsAndTheRestStaysOut) {
  const TemporaryFolder folder;
  const fs::path file = text_map(folder.path() / "case.nrrd", "Segment0_Name:=Spleen\nSegment0_LabelValue:=1\n");
  const auto map = read_label_map(file, {{1, "Liver"}, {3, "Liver"}});
  EXPECT_EQ(structures_of(*map), (Names{{1, "liver"}, {2, ""}, {3, "liver"}}));
  const imaging::Mask both = mask_of(*map, "liver");
  EXPECT_EQ(std::count(both.values.begin(), both.values.end(), 1), 8);
  EXPECT_EQ(read_label_map(file, {{7, "liver"}}).error().code, "labels-no-such-value");
}

// Few values are nobody's class numbers: 1 is what somebody drew first, and no spleen.
TEST(LabelMapTest, NumbersAloneNameNothingWhereTheyNeedNotBeTotalSegmentators) {
  const TemporaryFolder folder;
  const auto map = read_label_map(text_map(folder.path() / "case.nrrd", ""));
  EXPECT_EQ(structures_of(*map), (Names{{1, ""}, {2, ""}, {3, ""}}));
}

TEST(LabelMapTest, NamesOfOthersBecomeOurs) {
  EXPECT_EQ(usual_structure_name("inferior_vena_cava"), "vena-cava");
  EXPECT_EQ(usual_structure_name("portal_vein_and_splenic_vein"), "portal-vein");
  EXPECT_EQ(usual_structure_name("Liver Tumor 3"), "tumour-3");
  EXPECT_EQ(usual_structure_name("liver_vessels"), "liver-vessels");
  EXPECT_EQ(usual_structure_name("Right kidney"), "kidney-right");
}

// Two series of one patient or of two, written as DICOM, taken into one case.
class BelongingTest : public testing::Test {
 protected:
  imaging::Study series(const std::string& patient, const std::string& study, const std::string& frame,
                        double x_mm = 0) const {
    imaging::Volume volume;
    volume.grid.size = {8, 7, 5};
    volume.grid.spacing_mm = {4, 4, 4};
    volume.grid.origin_mm = {x_mm, 0, 0};
    volume.values.assign(volume.grid.voxels(), 10.0F);
    volume.values[3] = 30.0F;
    imaging::SeriesDescription description;
    description.patient_name = patient;
    description.patient_id = patient + " 123456";
    description.study_uid = imaging::uid_from_name(study);
    description.frame_of_reference_uid = imaging::uid_from_name(frame);
    description.series_uid = imaging::uid_from_name(patient + study + frame + std::to_string(x_mm));
    description.series_description = "T1";
    const fs::path folder = temporary_.path() / imaging::uid_from_name(description.series_uid);
    EXPECT_TRUE(imaging::write_dicom_series(folder, volume, description));
    return imaging::scan(folder).value();
  }
  std::vector<std::string> doubts(const imaging::Study& study) const {
    return messages(doubts_of_belonging(Case::open(folder_).value(), study, role(study, imaging::Role::mre_magnitude)));
  }
  static std::vector<SeriesRole> role(const imaging::Study& study, imaging::Role role) {
    return {{study.series.front().uid, role}};
  }
  void SetUp() override {
    auto made = Case::create(folder_);
    const imaging::Study hers = series("HERS^NAME", "study", "frame");
    ASSERT_TRUE(import_series_as(*made, hers, role(hers, imaging::Role::anatomy)));
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "hers.glisson";
};

TEST_F(BelongingTest, TheCaseTellsHerImagesFromAnothersWithoutKnowingHerName) {
  const std::string kept = read_text_file(folder_ / "case.json").value();
  for (const char* clear : {"HERS", "NAME", "123456"}) EXPECT_THAT(kept, Not(HasSubstr(clear)));
  EXPECT_THAT(doubts(series("HERS^NAME", "study", "frame", 4)), SizeIs(0));
  EXPECT_THAT(doubts(series("HIS^NAME", "study", "frame")), testing::ElementsAre(HasSubstr("another patient")));
  EXPECT_THAT(doubts(series("HERS^NAME", "later", "frame")), testing::ElementsAre(HasSubstr("another examination")));
  EXPECT_THAT(doubts(series("HERS^NAME", "study", "moved")), testing::ElementsAre(HasSubstr("frame of reference")));
  EXPECT_THAT(doubts(series("HERS^NAME", "study", "frame", 24)),
              testing::ElementsAre(HasSubstr("only 25 % of their place")));
}

TEST_F(BelongingTest, NothingIsReplacedUnlessAPersonSaysSo) {
  auto opened = Case::open(folder_).value();
  const imaging::Study his = series("HIS^NAME", "study", "frame"), hers = series("HERS^NAME", "study", "frame", 4);
  const std::string before = read_text_file(folder_ / "case.json").value();
  const auto anatomy = imaging::Role::anatomy;
  EXPECT_EQ(import_series_as(opened, his, role(his, anatomy)).error().code, "import-not-this-patient");
  EXPECT_EQ(import_series_as(opened, hers, role(hers, anatomy)).error().code, "import-would-replace");
  EXPECT_EQ(read_text_file(folder_ / "case.json").value(), before);
  EXPECT_TRUE(import_series_as(opened, hers, role(hers, imaging::Role::mre_confidence)));
  EXPECT_TRUE(import_series_as(opened, his, role(his, anatomy), {}, Replacing::wanted));
  EXPECT_EQ(messages(doubts_of_belonging(opened, hers, role(hers, imaging::Role::mre_magnitude))).size(), 1u);
}

}  // namespace
}  // namespace glisson::casefile
