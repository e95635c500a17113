// De-identified files say nothing of the patient, and are still the same study.

#include "imaging/deidentify.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <map>

#include "base/files.h"
#include "imaging/dicom_seg.h"
#include "imaging/dicom_uid.h"
#include "imaging/dicom_write.h"
#include "imaging/read_series.h"
#include "imaging/segment_codes.h"
#include "support/data.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;

// Two series of one study, full of identity, also in a nested sequence and in private elements.
void write_identified_study(const fs::path& folder) {
  Volume volume;
  volume.grid.size = {6, 5, 4};
  volume.values.resize(volume.grid.voxels());
  for (std::size_t i = 0; i < volume.values.size(); ++i) volume.values[i] = static_cast<float>(i) * 40;
  SeriesDescription series;
  series.patient_name = "SECRETNAME^JANE";
  series.patient_id = "SECRETID";
  series.patient_comments = "SECRETCOMMENT";
  series.study_description = "SECRETSTUDY";
  series.study_date = "20201231";
  series.study_uid = "1.2.3.444";
  series.frame_of_reference_uid = "1.2.3.555";
  series.rescale_slope = 1;
  for (const char* kind : {"T1 SECRETTEXT", "MRE stiffness SECRETTEXT"}) {
    series.series_description = kind;
    series.series_uid = uid_from_name(kind);
    const auto files = write_dicom_series(folder / kind, volume, series);
    ASSERT_TRUE(files);
    for (const fs::path& file : *files) {
      DcmFileFormat format;
      ASSERT_TRUE(format.loadFile(file.c_str()).good());
      DcmDataset& data = *format.getDataset();
      data.putAndInsertString(DCM_InstitutionName, "SECRETHOSPITAL");
      data.putAndInsertString(DCM_PatientBirthDate, "19501122");
      data.putAndInsertString(DCM_OperatorsName, "SECRETOPERATOR");
      DcmItem* item = nullptr;
      data.findOrCreateSequenceItem(DCM_ReferencedImageSequence, item, 0);
      item->putAndInsertString(DCM_ReferencedSOPInstanceUID, "1.2.3.444.999");
      item->putAndInsertString(DCM_PersonName, "SECRETNESTED");
      data.putAndInsertString(DcmTag(0x0043, 0x0010, EVR_LO), "GEMS_PARM_01");
      data.putAndInsertString(DcmTag(0x0043, 0x1001, EVR_LO), "SECRETPRIVATE");
      ASSERT_TRUE(format.saveFile(file.c_str(), EXS_LittleEndianExplicit).good());
    }
  }
}

class Deidentified : public testing::Test {
 protected:
  void SetUp() override {
    write_identified_study(source_.path());
    auto done = deidentify(source_.path(), out_.path(), {"a key"});
    ASSERT_TRUE(done) << done.error().message();
    result_ = std::move(*done);
  }
  TemporaryFolder source_, out_;
  DeidentifyResult result_;
};

TEST_F(Deidentified, SaysNothingOfThePatientAnywhere) {
  ASSERT_EQ(result_.files.size(), 8U);
  for (const fs::path& file : result_.files) {
    const std::string bytes = *read_text_file(file);
    for (const char* text : {"SECRET", "JANE", "1950", "20201231", "1.2.3.444", "1.2.3.555"}) {
      EXPECT_EQ(bytes.find(text), std::string::npos) << text << " in " << file;
      EXPECT_EQ(file.string().find(text), std::string::npos);
    }
  }
  EXPECT_EQ(result_.removed.at("PatientName"), 8);
  EXPECT_EQ(result_.removed.at("InstitutionName"), 8);
  EXPECT_GT(result_.removed.at("private elements"), 0);
}

TEST_F(Deidentified, IsStillTheSameStudy) {
  const auto before = scan(source_.path()), after = scan(out_.path());
  ASSERT_TRUE(before && after);
  ASSERT_EQ(after->series.size(), before->series.size());
  for (const Series& was : before->series) {
    const auto is = std::find_if(after->series.begin(), after->series.end(),
                                 [&](const Series& series) { return series.role == was.role; });
    ASSERT_NE(is, after->series.end()) << role_name(was.role) << " is lost";
    EXPECT_NE(is->uid, was.uid);
    EXPECT_EQ(is->study_uid, after->series.front().study_uid);
    EXPECT_EQ(is->frame_of_reference_uid, after->series.front().frame_of_reference_uid);
    EXPECT_TRUE(same_grid(is->grid, was.grid));
    EXPECT_EQ(read_series(*is)->values, read_series(was)->values);
    EXPECT_THAT(is->problems, testing::ContainerEq(was.problems));
  }
}

TEST_F(Deidentified, GetsTheSameIdentifiersFromTheSameKeyOnly) {
  const TemporaryFolder same, other;
  const auto again = deidentify(source_.path(), same.path(), {"a key"});
  const auto differently = deidentify(source_.path(), other.path(), {"another"});
  ASSERT_TRUE(again && differently);
  const auto name = [](const DeidentifyResult& result) { return result.files.front().filename(); };
  EXPECT_EQ(name(*again), name(result_));
  EXPECT_NE(name(*differently), name(result_));
}

// Copies of one picture, of which another program has changed one.
TEST_F(Deidentified, KeepsWhatAnEarlierRunWroteUnderTheSameIdentifiers) {
  const TemporaryFolder changed;
  fs::copy(source_.path(), changed.path(), fs::copy_options::recursive);
  const fs::path first = changed.path() / "T1 SECRETTEXT";
  for (const auto& entry : fs::directory_iterator(first)) {
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(entry.path().c_str()).good());
    format.getDataset()->putAndInsertString(DCM_RescaleIntercept, "5");
    ASSERT_TRUE(format.saveFile(entry.path().c_str(), EXS_LittleEndianExplicit).good());
  }
  std::map<fs::path, std::string> before;
  for (const fs::path& file : result_.files) before[file] = *read_text_file(file);

  const auto again = deidentify(source_.path(), out_.path(), {"a key"});
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->files, result_.files);
  const auto other = deidentify(changed.path(), out_.path(), {"a key"});
  ASSERT_TRUE(other) << other.error().message();
  EXPECT_THAT(other->files, testing::SizeIs(8));
  for (const auto& [file, bytes] : before) EXPECT_EQ(*read_text_file(file), bytes) << file;
  const auto are_second = std::count_if(other->files.begin(), other->files.end(),
                                        [](const fs::path& file) { return file.stem().string().ends_with("-2"); });
  EXPECT_EQ(are_second, 4);
}

TEST_F(Deidentified, NeverWritesIntoTheSource) {
  EXPECT_EQ(deidentify(source_.path(), source_.path() / "out").error().code, "deidentify-inside-source");
  EXPECT_EQ(deidentify(source_.path(), source_.path()).error().code, "deidentify-inside-source");
}

TEST_F(Deidentified, SkipsWhatIsNoImageAndSaysSo) {
  const TemporaryFolder mixed, out;
  ASSERT_TRUE(write_text_file(mixed.path() / "letter.txt", "Dear Jane"));
  EXPECT_EQ(deidentify(mixed.path(), out.path()).error().code, "deidentify-nothing");
  fs::copy(source_.path(), mixed.path(), fs::copy_options::recursive);
  const auto done = deidentify(mixed.path(), out.path());
  ASSERT_TRUE(done);
  ASSERT_EQ(done->skipped.size(), 1U);
  EXPECT_EQ(done->skipped.front().path.filename(), "letter.txt");
}

TEST_F(Deidentified, SkipsALinkThatLeadsToItselfAndSaysSo) {
  const TemporaryFolder mixed, out;
  fs::copy(source_.path(), mixed.path(), fs::copy_options::recursive);
  fs::create_symlink("loop", mixed.path() / "loop");
  const auto done = deidentify(mixed.path(), out.path());
  ASSERT_TRUE(done) << done.error().message();
  EXPECT_EQ(done->files.size(), 8U);
  ASSERT_EQ(done->skipped.size(), 1U);
  EXPECT_EQ(done->skipped.front().path.filename(), "loop");
  EXPECT_EQ(deidentify(mixed.path() / "loop", out.path()).error().code, "path-not-found");
}

// These were stripped before, of their identifiers too, and are JPEG 2000, which is passed on as it is.
TEST(Deidentify, TakesFilesThatLackIdentifiers) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const TemporaryFolder out;
  const auto done = deidentify(test::shared_data() / "totalseg_abdomen_mr_ct" / "example_ct_dicom", out.path());
  ASSERT_TRUE(done) << done.error().message();
  const auto study = scan(out.path());
  ASSERT_EQ(study->series.size(), 1U);
  EXPECT_EQ(study->series.front().grid.size, (std::array<int, 3>{512, 512, 20}));
  EXPECT_TRUE(read_series(study->series.front()));
}

TEST(Deidentify, KeepsARealSegmentationReadable) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const TemporaryFolder out;
  const auto done = deidentify(test::shared_data() / "dcmqi_liver_seg_ct3" / "liver.dcm", out.path());
  ASSERT_TRUE(done) << done.error().message();
  const std::string bytes = *read_text_file(done->files.front());
  for (const char* text : {"JANCT000", "99000", "UIowa", "1.2.392.200103"}) {
    EXPECT_EQ(bytes.find(text), std::string::npos) << text;
  }
  const auto study = scan(out.path());
  ASSERT_EQ(study->series.size(), 1U);
  EXPECT_EQ(study->series.front().role, Role::segmentation);
}

// What a segmentation of ours is coded with stays, word for word; a code with another meaning gets the known one.
TEST(Deidentify, KeepsTheCodesOfOurOwnSegmentations) {
  const TemporaryFolder folder;
  const char* names[] = {"liver",       "segment I", "segment VIII", "portal-vein", "hepatic-vein",
                         "gallbladder", "cyst",      "artery",       "tumour-1",    "other"};
  std::vector<SegmentedMask> segments;
  Grid grid;
  grid.size = {8, 6, 3};
  for (const char* name : names) {
    const int value = static_cast<int>(segments.size()) + 1;
    segments.push_back({{name, value, {0.5, 0.5, 0.5}}, {grid, std::vector<std::uint8_t>(grid.voxels(), 1)}});
  }
  SegmentationSource source;
  source.study_uid = "2.25.1";
  source.series_uid = "2.25.2";
  source.frame_of_reference_uid = "2.25.3";
  const fs::path file = folder.path() / "seg.dcm";
  ASSERT_TRUE(write_dicom_seg(file, segments, source));
  DcmFileFormat planted;
  ASSERT_TRUE(planted.loadFile(file.c_str()).good());
  DcmItem *segment = nullptr, *type = nullptr;
  planted.getDataset()->findAndGetSequenceItem(DCM_SegmentSequence, segment, 0);
  ASSERT_TRUE(segment != nullptr &&
              segment->findAndGetSequenceItem(DCM_SegmentedPropertyTypeCodeSequence, type).good());
  type->putAndInsertString(DCM_CodeMeaning, "SECRETMEANING");
  ASSERT_TRUE(planted.saveFile(file.c_str(), EXS_LittleEndianExplicit).good());

  const TemporaryFolder out;
  const auto done = deidentify(folder.path(), out.path());
  ASSERT_TRUE(done) << done.error().message();
  DcmFileFormat cleaned;
  ASSERT_TRUE(cleaned.loadFile(done->files.front().c_str()).good());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    ASSERT_TRUE(
        cleaned.getDataset()->findAndGetSequenceItem(DCM_SegmentSequence, segment, static_cast<long>(s)).good());
    const SegmentCode expected = segment_code(names[s]);
    for (const auto& [tag, code] : {std::pair{DCM_SegmentedPropertyCategoryCodeSequence, expected.category},
                                    std::pair{DCM_SegmentedPropertyTypeCodeSequence, expected.type}}) {
      OFString value, meaning;
      ASSERT_TRUE(segment->findAndGetSequenceItem(tag, type).good()) << names[s];
      type->findAndGetOFString(DCM_CodeValue, value);
      type->findAndGetOFString(DCM_CodeMeaning, meaning);
      EXPECT_STREQ(value.c_str(), code.value) << names[s];
      EXPECT_STREQ(meaning.c_str(), code.meaning) << names[s];
    }
  }
}

}  // namespace
}  // namespace glisson::imaging
