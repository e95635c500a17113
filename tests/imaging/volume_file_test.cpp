// Volume files: what is written is read back, positions are the patient's, and what a header lies about is refused.

#include "imaging/volume_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <fstream>

#include "base/files.h"
#include "support/data.h"

namespace glisson::imaging {
namespace {

// A grid that no axis swap or sign error leaves as it is: three sizes, three spacings, rotated about two axes.
Grid oblique_volume_grid() {
  Grid grid;
  grid.size = {7, 5, 3};
  grid.spacing_mm = {1.5, 2.0, 4.0};
  grid.origin_mm = {-31.25, 12.5, -208.0};
  grid.direction =
      (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  return grid;
}

Volume counting_volume() {
  Volume volume;
  volume.grid = oblique_volume_grid();
  for (std::size_t i = 0; i < volume.grid.voxels(); ++i) volume.values.push_back(0.25f * static_cast<float>(i) - 3);
  volume.unit = "kPa";
  return volume;
}

class VolumeFileKinds : public testing::TestWithParam<const char*> {};

TEST_P(VolumeFileKinds, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path() / (std::string("volume") + GetParam());
  const Volume volume = counting_volume();
  ASSERT_TRUE(write_volume_file(file, volume));
  const auto read = read_volume_file(file);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->values, volume.values);
  // NIfTI keeps positions as 32-bit floats and the rotation as a quaternion: some 1e-5 mm at 200 mm.
  EXPECT_TRUE(same_grid(read->grid, volume.grid, 1e-3));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "something was left beside";
}

INSTANTIATE_TEST_SUITE_P(Kinds, VolumeFileKinds, testing::Values(".nrrd", ".nii", ".nii.gz", ".mha"));

TEST(VolumeFile, KeepsTheUnitInNrrd) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_volume_file(folder.path() / "stiffness.nrrd", counting_volume()));
  EXPECT_EQ(read_volume_file(folder.path() / "stiffness.nrrd")->unit, "kPa");
}

// The mask must open in 3D Slicer as a named, coloured segment: these are the fields that it looks for.
TEST(MaskFile, IsANamedSegmentForSlicer) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "liver.nrrd";
  Mask mask{oblique_volume_grid(), {}};
  for (std::size_t i = 0; i < mask.grid.voxels(); ++i) mask.values.push_back(i % 3 == 0);
  ASSERT_TRUE(write_mask_file(file, mask, {"liver", 5, {0.5, 0.25, 1.0}}));

  const std::string text = *read_text_file(file);
  for (const char* field : {"encoding: gzip", "space: left-posterior-superior", "Segment0_ID:=liver",
                            "Segment0_Name:=liver", "Segment0_Color:=0.5 0.25 1", "Segment0_LabelValue:=5",
                            "Segment0_Extent:=0 6 0 4 0 2", "Segmentation_MasterRepresentation:=Binary labelmap"}) {
    EXPECT_THAT(text, testing::HasSubstr(field));
  }

  const auto read = read_mask_file(file);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->mask.values, mask.values);
  EXPECT_TRUE(same_grid(read->mask.grid, mask.grid));
  EXPECT_EQ(read->info.name, "liver");
  EXPECT_EQ(read->info.label_value, 5);
  EXPECT_EQ(read->info.color_rgb, (std::array<double, 3>{0.5, 0.25, 1.0}));
}

TEST(LabelsFile, RefusesValuesThatAreNoLabels) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_volume_file(folder.path() / "stiffness.nrrd", counting_volume()));
  const auto labels = read_labels_file(folder.path() / "stiffness.nrrd");
  ASSERT_FALSE(labels);
  EXPECT_EQ(labels.error().code, "volume-file-not-labels");
  EXPECT_THAT(labels.error().message(), testing::HasSubstr("-3"));
}

std::string code_of_reading(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / name, std::ios::binary) << content;
  const auto volume = read_volume_file(folder.path() / name);
  return volume ? "read" : volume.error().code;
}

std::string nrrd(const std::string& sizes, const std::string& payload, const std::string& encoding = "raw") {
  return "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: " + sizes +
         "\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nendian: little\nencoding: " +
         encoding + "\nspace origin: (0,0,0)\n\n" + payload;
}

TEST(VolumeFile, RefusesWhatItCannotTrust) {
  EXPECT_EQ(code_of_reading("a.nrrd", nrrd("2 2 2", std::string(32, '\0'))), "read");
  EXPECT_EQ(code_of_reading("a.nrrd", nrrd("2 2 2", std::string(20, '\0'))), "volume-file-truncated");
  EXPECT_EQ(code_of_reading("a.nrrd", nrrd("2000000 2000000 2000000", "x")), "volume-file-truncated");
  EXPECT_EQ(code_of_reading("a.nrrd", nrrd("100000 100000 100000", "x", "gzip")), "volume-file-truncated");
  EXPECT_EQ(code_of_reading("a.nrrd", ""), "volume-file-unreadable");
  EXPECT_EQ(code_of_reading("a.nrrd", "once upon a time"), "volume-file-unreadable");
  EXPECT_EQ(code_of_reading("a.nii", std::string(352, 'n')), "volume-file-unreadable");
  EXPECT_EQ(code_of_reading("a.nii.gz", "\x1f\x8b broken"), "volume-file-unreadable");
  EXPECT_EQ(code_of_reading("a.mha",
                            "ObjectType = Image\nNDims = 3\nDimSize = 4000 4000 4000\nElementType = MET_FLOAT\n"
                            "ElementDataFile = LOCAL\nx"),
            "volume-file-truncated");
  EXPECT_EQ(code_of_reading("a.jpg", "x"), "volume-file-unknown-type");
  const Error nowhere = read_volume_file("/nowhere/at/all.nrrd").error();
  EXPECT_EQ(nowhere.code, "volume-file-unreadable");
  EXPECT_EQ(nowhere.message(), "/nowhere/at/all.nrrd cannot be opened: it has gone, or is no ordinary file.");
}

TEST(VolumeFile, RefusesATruncatedNifti) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "volume.nii";
  ASSERT_TRUE(write_volume_file(file, counting_volume()));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 380);  // most of 7 x 5 x 3 floats are gone
  const auto volume = read_volume_file(file);
  ASSERT_FALSE(volume);
  EXPECT_THAT(volume.error().code, testing::AnyOf("volume-file-truncated", "volume-file-unreadable"));
}

// NIfTI speaks RAS: the first patient axis must come out turned. The abdominal MR is stored with its rows running to
// the patient's right or left, and its liver must lie on the right, at smaller x than the body's middle.
TEST(VolumeFile, PlacesRealNiftiInPatientCoordinates) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const auto labels_file = test::shared_data() / "totalseg_abdomen_mr_ct" / "example_seg_mr.nii.gz";
  const auto labels = read_labels_file(labels_file);
  ASSERT_TRUE(labels) << labels.error().message();
  Eigen::Vector3d liver(0, 0, 0), body(0, 0, 0);
  double liver_voxels = 0, body_voxels = 0;
  for (int k = 0; k < labels->grid.size[2]; ++k) {
    for (int j = 0; j < labels->grid.size[1]; ++j) {
      for (int i = 0; i < labels->grid.size[0]; ++i) {
        const Eigen::Vector3d position = labels->grid.position_mm(i, j, k);
        body += position;
        ++body_voxels;
        if (labels->at(i, j, k) != 5) continue;
        liver += position;
        ++liver_voxels;
      }
    }
  }
  ASSERT_GT(liver_voxels, 0);
  EXPECT_LT(liver.x() / liver_voxels, body.x() / body_voxels);
}

}  // namespace
}  // namespace glisson::imaging
