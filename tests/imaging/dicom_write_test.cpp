// A series that we write is one that scan and read_series find again, exactly, with nothing to complain of.

#include "imaging/dicom_write.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/files.h"
#include "imaging/dicom_uid.h"
#include "imaging/internal/dicom_text.h"
#include "imaging/read_series.h"

namespace glisson::imaging {
namespace {

Volume oblique_volume() {
  Volume volume;
  volume.grid.size = {9, 7, 5};
  volume.grid.spacing_mm = {1.64, 1.25, 10.0 / 3};  // no decimal fraction: 16 characters must do
  volume.grid.origin_mm = {-101.123456789, 33.3, -410.0000001};
  volume.grid.direction =
      (Eigen::AngleAxisd(0.31, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.17, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  for (std::size_t i = 0; i < volume.grid.voxels(); ++i) {
    volume.values.push_back(static_cast<float>(1000 * std::sin(0.7 * static_cast<double>(i))));
  }
  return volume;
}

SeriesDescription described() {
  SeriesDescription series;
  series.patient_name = "NOBODY^TEST";
  series.study_uid = uid_from_name("study");
  series.series_uid = uid_from_name("series");
  series.frame_of_reference_uid = uid_from_name("frame");
  series.series_description = "T1";
  return series;
}

TEST(DicomWrite, ComesBackThroughScanningAndReading) {
  const TemporaryFolder folder;
  const Volume volume = oblique_volume();
  const auto files = write_dicom_series(folder.path() / "series", volume, described());
  ASSERT_TRUE(files) << files.error().message();
  EXPECT_EQ(files->size(), 5U);

  const auto study = scan(folder.path());
  ASSERT_TRUE(study);
  ASSERT_EQ(study->series.size(), 1U);
  const Series& series = study->series.front();
  EXPECT_THAT(series.problems, testing::IsEmpty());
  EXPECT_EQ(series.uid, described().series_uid);
  EXPECT_EQ(series.modality, "MR");
  // 16 characters leave at least 12 decimals of a direction: nothing over a micrometre across the volume.
  EXPECT_TRUE(same_grid(series.grid, volume.grid, 1e-6));

  const auto read = read_series(series);
  ASSERT_TRUE(read) << read.error().message();
  // The range of 2000 falls on 32767 steps; a value is off by half a step at most.
  constexpr float half_step = 2000.0f / 32767 / 2 * 1.01f;
  for (std::size_t i = 0; i < volume.values.size(); ++i) ASSERT_NEAR(read->values[i], volume.values[i], half_step);
}

TEST(DicomWrite, KeepsWholeNumbersExactlyUnderTheGivenRescale) {
  const TemporaryFolder folder;
  Volume volume = oblique_volume();
  for (float& value : volume.values) value = std::round(value) / 4;
  SeriesDescription series = described();
  series.rescale_slope = 0.25;
  ASSERT_TRUE(write_dicom_series(folder.path(), volume, series));
  const auto study = scan(folder.path());
  EXPECT_EQ(read_series(study->series.front())->values, volume.values);
}

TEST(DicomWrite, PutsPhaseOffsetsInOneSeriesAsVolumes) {
  const TemporaryFolder folder;
  Volume volume = oblique_volume();
  SeriesDescription series = described();
  series.rescale_slope = 1;
  for (int number = 1; number <= 3; ++number) {
    std::fill(volume.values.begin(), volume.values.end(), static_cast<float>(number));
    series.temporal_position = {number, 3, 5.0 * number};
    ASSERT_TRUE(write_dicom_series(folder.path(), volume, series));
  }
  const auto study = scan(folder.path());
  ASSERT_EQ(study->series.size(), 1U);
  ASSERT_EQ(study->series.front().volumes, 3);
  for (int v = 0; v < 3; ++v) {
    EXPECT_EQ(read_series(study->series.front(), v)->values[0], static_cast<float>(v + 1));
  }
}

TEST(DicomWrite, RefusesWhatSixteenBitsCannotHold) {
  const TemporaryFolder folder;
  Volume volume = oblique_volume();
  SeriesDescription series = described();
  series.rescale_slope = 0.01;  // a thousand would be stored as 100000
  EXPECT_EQ(write_dicom_series(folder.path(), volume, series).error().code, "dicom-write-range");
  volume.values[7] = std::numeric_limits<float>::quiet_NaN();
  series.rescale_slope = 1;
  EXPECT_EQ(write_dicom_series(folder.path(), volume, series).error().code, "dicom-write-range");
  EXPECT_EQ(write_dicom_series(folder.path(), Volume{}, series).error().code, "dicom-write-empty");
  Volume wide;
  wide.grid.size = {70000, 1, 1};
  wide.values.resize(70000);
  EXPECT_EQ(write_dicom_series(folder.path(), wide, series).error().code, "dicom-write-too-large");
  series.series_uid.clear();
  EXPECT_EQ(write_dicom_series(folder.path(), oblique_volume(), series).error().code, "dicom-write-no-uid");
}

TEST(DecimalString, IsTheNearestNumberThatSixteenCharactersHold) {
  EXPECT_EQ(decimal_string(0.1), "0.1");
  EXPECT_EQ(decimal_string(-0.0), "0");
  EXPECT_EQ(decimal_string(3), "3");
  for (const double number : {10.0 / 3, -10.0 / 3, -1.0 / 3e5, 1.23456789012345e-7, -9.87654321098765e200, 1e-300}) {
    const std::string text = decimal_string(number);
    EXPECT_LE(text.size(), 16U) << text;
    // A minus sign, a point and an exponent of five characters leave nine digits.
    EXPECT_NEAR(std::stod(text) / number, 1, 1e-8) << text;
  }
}

TEST(Uid, FollowsFromItsNameAndIsAUid) {
  const std::string uid = uid_from_name("a study");
  EXPECT_EQ(uid, uid_from_name("a study"));
  EXPECT_NE(uid, uid_from_name("another"));
  EXPECT_THAT(uid, testing::MatchesRegex("2\\.25\\.[1-9][0-9]*"));
  EXPECT_LE(uid.size(), 44U);
}

}  // namespace
}  // namespace glisson::imaging
