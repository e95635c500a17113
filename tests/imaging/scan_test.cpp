// What a scan finds: slices in their places, whatever the files are called, and every fault by its name.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <numbers>
#include <thread>

#include "base/files.h"
#include "imaging/read_series.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;
using test::save_slice;
using test::save_stack;
using test::SliceSpec;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Scan : public testing::Test {
 protected:
  Study scanned() const {
    const Result<Study> study = scan(folder_.path());
    EXPECT_TRUE(study.has_value());
    return study.value_or(Study{});
  }
  // The only series there is.
  Series only_series() const {
    const Study study = scanned();
    EXPECT_EQ(study.series.size(), 1U);
    return study.series.empty() ? Series{} : study.series.front();
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

TEST_F(Scan, OrdersSlicesByPositionNeverByNameOrNumber) {
  save_stack(folder_.path(), 5);  // names and numbers run downwards
  const Series series = only_series();
  EXPECT_THAT(series.problems, IsEmpty());
  EXPECT_EQ(series.grid.size, (std::array{8, 6, 5}));
  EXPECT_EQ(series.files.front().filename(), "IM_0005.dcm");
  EXPECT_EQ(series.files.back().filename(), "IM_0001.dcm");
  EXPECT_LT((series.grid.position_mm(0, 0, 4) - Eigen::Vector3d(-10, -20, 42)).norm(), 1e-9);
  EXPECT_EQ(series.role, Role::anatomy);
}

TEST_F(Scan, TakesTheSpacingFromPositionsAndNotFromSliceThickness) {
  save_stack(folder_.path(), 4, {}, 2.5);  // SliceThickness says 17 everywhere
  EXPECT_LT((only_series().grid.spacing_mm - Eigen::Vector3d(1.5, 2, 2.5)).norm(), 1e-9);
}

TEST_F(Scan, OrdersObliqueSlicesAlongTheirNormal) {
  SliceSpec spec;
  spec.along_row = Eigen::Vector3d(1, 1, 0).normalized();
  spec.along_column = Eigen::Vector3d(0, 0, -1);  // coronal, turned: the normal is (-1, 1, 0) / sqrt 2
  save_stack(folder_.path(), 6, spec);
  const Grid grid = only_series().grid;
  const Eigen::Vector3d last = spec.position_mm + Eigen::Vector3d(-1, 1, 0).normalized() * 15;
  EXPECT_LT((grid.position_mm(0, 0, 5) - last).norm(), 1e-6);
  EXPECT_NEAR(grid.direction.determinant(), 1, 1e-9);
}

TEST_F(Scan, NamesTheNeighboursOfAMissingSliceAndKeepsTheSpacing) {
  save_stack(folder_.path(), 8);
  fs::remove(path("IM_0004.dcm"));  // slice 4 of 0..7, at 12 mm
  const Series series = only_series();
  EXPECT_THAT(series.problems, Contains(AllOf(HasSubstr("One slice is missing"), HasSubstr("IM_0005.dcm"),
                                              HasSubstr("IM_0003.dcm"), HasSubstr("6 mm"))));
  EXPECT_EQ(series.grid.size[2], 8);
  EXPECT_NEAR(series.grid.spacing_mm[2], 3, 1e-9);
  // Values are 100 k, so that the interpolated slice holds exactly what was lost.
  const Result<Volume> volume = read_series(series);
  ASSERT_TRUE(volume.has_value());
  for (int k = 0; k < 8; ++k) EXPECT_FLOAT_EQ(volume->at(3, 2, k), 100.0F * static_cast<float>(k));
}

TEST_F(Scan, NamesBothFilesOfADoubledSlice) {
  save_stack(folder_.path(), 5);
  SliceSpec spec;
  spec.position_mm[2] += 6;
  spec.instance_number = 77;
  save_slice(spec, path("again.dcm"));
  const Series series = only_series();
  EXPECT_THAT(series.problems,
              Contains(AllOf(HasSubstr("there twice"), HasSubstr("IM_0003.dcm"), HasSubstr("again.dcm"))));
  EXPECT_EQ(series.volumes, 1);
  EXPECT_EQ(series.grid.size[2], 5);
}

TEST_F(Scan, LeavesOutTheSamePictureUnderAnotherName) {
  save_stack(folder_.path(), 5);
  fs::copy_file(path("IM_0002.dcm"), path("copy.dcm"));
  const Series series = only_series();
  EXPECT_THAT(series.problems,
              Contains(AllOf(HasSubstr("same picture"), HasSubstr("IM_0002.dcm"), HasSubstr("copy.dcm"))));
  EXPECT_EQ(series.files.size(), 5U);
}

TEST_F(Scan, SaysWhereTheSpacingIsUneven) {
  double z = 0;
  int number = 1;
  for (const double gap : {3.0, 3.0, 3.8, 3.0, 3.0, 3.0}) {
    SliceSpec spec;
    spec.position_mm[2] = z;
    spec.instance_number = number;
    save_slice(spec, path(fmt::format("{}.dcm", number++)));
    z += gap;
  }
  EXPECT_THAT(only_series().problems,
              Contains(AllOf(HasSubstr("uneven"), HasSubstr("3.dcm"), HasSubstr("4.dcm"), HasSubstr("3.8 mm"))));
}

TEST_F(Scan, KeepsEveryVoxelInItsPlaceUnderGantryTilt) {
  const double tilt = 15 * std::numbers::pi / 180;
  for (int k = 0; k < 5; ++k) {
    SliceSpec spec;
    spec.modality = "CT";
    spec.instance_number = k + 1;
    spec.position_mm = Eigen::Vector3d(-10, -20 + 3 * k * std::tan(tilt), 30 + 3 * k);
    const auto file = test::dicom_slice(spec);
    file->getDataset()->putAndInsertString(DCM_GantryDetectorTilt, "15");
    file->getDataset()->putAndInsertString(DCM_RescaleIntercept, "-1024");
    file->getDataset()->putAndInsertString(DCM_RescaleSlope, "1");
    test::save(*file, path(fmt::format("{}.dcm", k)));
  }
  const Series series = only_series();
  EXPECT_THAT(series.problems, Contains(AllOf(HasSubstr("15.0 degrees"), HasSubstr("gantry tilt"))));
  const Eigen::Vector3d expected(-10, -20 + 12 * std::tan(tilt), 42);
  EXPECT_LT((series.grid.position_mm(0, 0, 4) - expected).norm(), 1e-6);
  EXPECT_LT((series.grid.index_of(expected) - Eigen::Vector3d(0, 0, 4)).norm(), 1e-6);
}

TEST_F(Scan, PartsASeriesOfSeveralOrientationsAndSizes) {
  save_stack(folder_.path() / "axial", 4);
  SliceSpec coronal;
  coronal.along_column = Eigen::Vector3d(0, 0, -1);
  save_stack(folder_.path() / "coronal", 3, coronal);
  SliceSpec large;
  large.rows = 10;
  large.instance_number = 99;
  save_slice(large, path("large.dcm"));
  const Study study = scanned();
  ASSERT_EQ(study.series.size(), 3U);
  EXPECT_EQ(study.series[0].uid, "1.2.3.4");
  EXPECT_EQ(study.series[1].uid, "1.2.3.4#2");
  EXPECT_EQ(study.series[0].grid.size[2], 4);
  EXPECT_EQ(study.series[1].grid.size[2], 3);
  EXPECT_EQ(study.series[2].grid.size, (std::array{8, 10, 1}));
  EXPECT_THAT(study.series[0].problems, Contains(HasSubstr("stack 1 of 3")));
}

TEST_F(Scan, CountsTheVolumesOfAPhaseSeries) {
  int number = 1;
  for (int offset = 1; offset <= 4; ++offset) {
    for (int k = 0; k < 3; ++k) {
      SliceSpec spec;
      spec.description = "MRE phase";
      spec.position_mm[2] = 5.0 * k;
      spec.instance_number = number++;
      spec.value = [=](int, int) { return 10 * offset + k; };
      const auto file = test::dicom_slice(spec);
      file->getDataset()->putAndInsertString(DCM_TemporalPositionIdentifier, std::to_string(offset).c_str());
      test::save(*file, path(fmt::format("{}.dcm", 100 - number)));
    }
  }
  const Series series = only_series();
  EXPECT_EQ(series.volumes, 4);
  EXPECT_EQ(series.volume_labels[2], "temporal position 3");
  const Result<Volume> third = read_series(series, 2);
  ASSERT_TRUE(third.has_value());
  EXPECT_FLOAT_EQ(third->at(0, 0, 0), 30);
  EXPECT_FLOAT_EQ(third->at(0, 0, 2), 32);
  EXPECT_EQ(read_series(series, 4).error().code, "series-no-such-volume");

  // One picture lost: its volume is left out and the others stay right.
  fs::remove(path("94.dcm"));  // number 5: offset 2, slice 1
  const Series incomplete = only_series();
  EXPECT_EQ(incomplete.volumes, 3);
  EXPECT_THAT(incomplete.problems, Contains(HasSubstr("temporal position 2 has only 2 of 3")));
}

TEST_F(Scan, CallsColourByItsNameAndRefusesToReadIt) {
  SliceSpec spec;
  spec.description = "MRE stiffness colour";
  spec.bits_allocated = spec.bits_stored = 8;
  spec.columns *= 3;
  const auto file = test::dicom_slice(spec);
  DcmDataset& data_set = *file->getDataset();
  data_set.putAndInsertUint16(DCM_Columns, 8);
  data_set.putAndInsertUint16(DCM_SamplesPerPixel, 3);
  data_set.putAndInsertUint16(DCM_PlanarConfiguration, 0);
  data_set.putAndInsertString(DCM_PhotometricInterpretation, "RGB");
  test::save(*file, path("colour.dcm"));
  const Series series = only_series();
  EXPECT_EQ(series.role, Role::other);
  EXPECT_THAT(series.problems, Contains(HasSubstr("in colour")));
  EXPECT_EQ(read_series(series).error().code, "dicom-colour");
}

TEST_F(Scan, SaysThatACtHasNoRescale) {
  SliceSpec spec;
  spec.modality = "CT";
  save_stack(folder_.path(), 3, spec);
  EXPECT_THAT(only_series().problems, Contains(HasSubstr("No rescale")));
}

TEST_F(Scan, SaysThatStiffnessAndAnatomyHaveDifferentFramesOfReference) {
  save_stack(folder_.path() / "a", 3);
  SliceSpec stiffness;
  stiffness.series_uid = "1.2.3.5";
  stiffness.series_number = 9;
  stiffness.description = "MRE Stiffness (kPa)";
  stiffness.frame_of_reference_uid = "1.2.10";
  save_stack(folder_.path() / "s", 3, stiffness);
  const Study study = scanned();
  ASSERT_EQ(study.series.size(), 2U);
  EXPECT_EQ(study.series[1].role, Role::mre_stiffness);
  EXPECT_THAT(study.series[1].problems, Contains(HasSubstr("frame of reference")));
}

TEST_F(Scan, ReadsTheFilesThatADicomdirNames) {
  save_stack(folder_.path() / "images", 3);
  save_slice({.series_uid = "1.2.3.99"}, path("not-named.dcm"));
  DcmFileFormat directory;
  DcmDataset& data_set = *directory.getDataset();
  data_set.putAndInsertString(DCM_SOPClassUID, UID_MediaStorageDirectoryStorage);
  data_set.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.77");
  for (int k = 0; k < 3; ++k) {
    DcmItem* record = nullptr;
    data_set.findOrCreateSequenceItem(DCM_DirectoryRecordSequence, record, k);
    // In capitals, as discs have it, while the files are not.
    record->putAndInsertString(DCM_ReferencedFileID, fmt::format("IMAGES\\IM_000{}.DCM", k + 1).c_str());
  }
  for (int k = 1; k <= 3; ++k) {
    fs::rename(path(fmt::format("images/IM_000{}.dcm", k)), path(fmt::format("images/im_000{}.dcm", k)));
  }
  test::save(directory, path("DICOMDIR"));
  const Result<Study> study = scan(path("DICOMDIR"));
  ASSERT_TRUE(study.has_value()) << study.error().message();
  ASSERT_EQ(study->series.size(), 1U);
  EXPECT_EQ(study->series.front().files.size(), 3U);
  EXPECT_THAT(study->skipped, IsEmpty());
}

TEST_F(Scan, GoesThroughTenThousandFilesAndCanBeStopped) {
  save_stack(folder_.path() / "one", 20);
  for (int copy = 0; copy < 500; ++copy) {
    const fs::path beside = folder_.path() / fmt::format("copy-{}", copy);
    fs::create_directory(beside);
    for (int k = 1; k <= 20; ++k) {
      const std::string name = fmt::format("IM_{:04}.dcm", k);
      fs::create_hard_link(folder_.path() / "one" / name, beside / name);
    }
  }
  int reports = 0;
  double furthest = 0;
  const Result<Study> study = scan(folder_.path(), Progress([&](double fraction, std::string_view) {
                                     ++reports;
                                     furthest = std::max(furthest, fraction);
                                   }));
  ASSERT_TRUE(study.has_value());
  EXPECT_EQ(study->series.front().files.size(), 20U);  // 10,020 files, the same 20 pictures
  EXPECT_GT(reports, 100);
  EXPECT_DOUBLE_EQ(furthest, 1);

  std::stop_source stop;
  int after_stop = 0;
  const Result<Study> stopped = scan(folder_.path(), Progress(
                                                         [&](double fraction, std::string_view) {
                                                           if (stop.stop_requested()) ++after_stop;
                                                           if (fraction > 0.3) stop.request_stop();
                                                         },
                                                         stop.get_token()));
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, "cancelled");
  EXPECT_LT(after_stop, 8);  // at most what the threads had in hand
}

TEST_F(Scan, SaysThatAPathLeadsNowhere) { EXPECT_EQ(scan(path("nowhere")).error().code, "path-not-found"); }

}  // namespace
}  // namespace glisson::imaging
