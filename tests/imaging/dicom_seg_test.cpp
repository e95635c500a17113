// DICOM SEG: a real one read like its NRRD twin; ours read back, by us and by DCMTK's own module for segmentations.

#include "imaging/dicom_seg.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>
#include <dcmtk/dcmseg/segutils.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <set>

#include "base/files.h"
#include "imaging/internal/cielab.h"
#include "imaging/segment_codes.h"
#include "imaging/volume_file.h"
#include "support/data.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;

TEST(DicomSeg, ReadsARealLiverVoxelForVoxelLikeItsNrrd) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const fs::path folder = test::shared_data() / "dcmqi_liver_seg_ct3";
  const auto segments = read_dicom_seg(folder / "liver.dcm");
  ASSERT_TRUE(segments) << segments.error().message();
  const auto twin = read_mask_file(folder / "liver_seg.nrrd");
  ASSERT_TRUE(twin) << twin.error().message();
  ASSERT_EQ(segments->size(), 1U);
  EXPECT_EQ(segments->front().info.name, "Liver");
  EXPECT_EQ(segments->front().mask.values, twin->mask.values);
  // The NRRD's origin has the tenth of a micrometre that the DICOM's seven digits do not.
  EXPECT_TRUE(same_grid(segments->front().mask.grid, twin->mask.grid, 1e-3));
  // The file stores the colour (221, 130, 101) that 3D Slicer gives a liver, in 16 bits a channel of CIELab.
  EXPECT_NEAR(segments->front().info.color_rgb[0] * 255, 221, 6);
  EXPECT_NEAR(segments->front().info.color_rgb[1] * 255, 130, 6);
  EXPECT_NEAR(segments->front().info.color_rgb[2] * 255, 101, 6);
}

// Two that overlap, a third that is empty, on an oblique grid whose planes are no whole number of bytes.
std::vector<SegmentedMask> three_segments(int columns = 13) {
  Grid grid;
  grid.size = {columns, 11, 6};
  grid.spacing_mm = {1.5, 1.25, 3.3};
  grid.origin_mm = {-120.5, -33.25, -401.0};
  grid.direction = (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()))
                       .toRotationMatrix();
  std::vector<SegmentedMask> segments(3);
  for (SegmentedMask& segment : segments) segment.mask = {grid, std::vector<std::uint8_t>(grid.voxels())};
  segments[0].info = {"liver", 1, {0.87, 0.51, 0.40}};
  segments[1].info = {"tumour-1", 2, {0.56, 0.93, 0.56}};
  segments[2].info = {"cyst", 3, {0.2, 0.2, 0.9}};
  for (int k = 1; k < 5; ++k) {
    for (int j = 2; j < 9; ++j) {
      for (int i = 1; i < 12; ++i) segments[0].mask.at(i, j, k) = 1;
    }
  }
  segments[1].mask.at(4, 5, 3) = segments[1].mask.at(5, 5, 3) = 1;
  return segments;
}

SegmentationSource made_up_source() {
  SegmentationSource source;
  source.patient_name = "NOBODY^TEST";
  source.patient_id = "1";
  source.study_uid = "2.25.1";
  source.series_uid = "2.25.2";
  source.frame_of_reference_uid = "2.25.3";
  source.content_date = "20260101";
  source.content_time = "080000";
  for (int k = 0; k < 6; ++k) source.instances.push_back({"1.2.840.10008.5.1.4.1.1.4", "2.25.4" + std::to_string(k)});
  return source;
}

TEST(DicomSeg, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const auto written = three_segments();
  ASSERT_TRUE(write_dicom_seg(folder.path() / "seg.dcm", written, made_up_source()));
  const auto read = read_dicom_seg(folder.path() / "seg.dcm");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->size(), written.size());
  for (std::size_t s = 0; s < written.size(); ++s) {
    EXPECT_EQ((*read)[s].mask.values, written[s].mask.values) << written[s].info.name;
    EXPECT_TRUE(same_grid((*read)[s].mask.grid, written[s].mask.grid));
    EXPECT_EQ((*read)[s].info.name, written[s].info.name);
    EXPECT_EQ((*read)[s].info.label_value, written[s].info.label_value);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR((*read)[s].info.color_rgb[c], written[s].info.color_rgb[c], 1e-3);
    }
  }
}

TEST(DicomSeg, IsTheSameBytesFromTheSameMasks) {
  const TemporaryFolder folder;
  for (const char* name : {"a.dcm", "b.dcm"}) {
    ASSERT_TRUE(write_dicom_seg(folder.path() / name, three_segments(), made_up_source()));
  }
  EXPECT_EQ(*sha256_of_file(folder.path() / "a.dcm"), *sha256_of_file(folder.path() / "b.dcm"));
}

TEST(DicomSeg, NamesCouinaudsSegmentsByTheirOwnCodes) {
  std::set<std::string> types;
  for (const char* roman : {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"}) {
    const SegmentCode code = segment_code(std::string("segment ") + roman);
    EXPECT_STREQ(code.category.meaning, "Anatomical Structure");
    EXPECT_EQ(std::string(code.type.meaning), std::string("Couinaud hepatic segment ") + roman);
    types.insert(code.type.value);
  }
  EXPECT_EQ(types.size(), 8U);
  EXPECT_STREQ(segment_code("segment IX").type.meaning, "Tissue");
  EXPECT_STREQ(segment_code("tumour-3").type.value, "108369006");
  EXPECT_THAT(slicer_tags("segment IV"), testing::HasSubstr("~SCT^277958008^Couinaud hepatic segment IV~"));
}

// dcmseg checks far more of the standard than our reader does, and finds the frames by itself. Of 16 columns, since
// dcmseg 3.6.7 goes wrong where a frame is no whole number of bytes (github.com/QIICR/dcmqi/issues/341).
TEST(DicomSeg, SatisfiesDcmtksOwnReader) {
  const TemporaryFolder folder;
  constexpr int columns = 16, rows = 11;
  const auto written = three_segments(columns);
  const fs::path file = folder.path() / "seg.dcm";
  ASSERT_TRUE(write_dicom_seg(file, written, made_up_source()));

  DcmSegmentation* loaded = nullptr;
  const OFCondition condition = DcmSegmentation::loadFile(file.c_str(), loaded);
  ASSERT_TRUE(condition.good()) << condition.text();
  const std::unique_ptr<DcmSegmentation> segmentation(loaded);
  EXPECT_TRUE(segmentation->check());
  ASSERT_EQ(segmentation->getNumberOfSegments(), 3U);
  ASSERT_EQ(segmentation->getNumberOfFrames(), 6U + 1 + 1) << "all planes, the tumour's one, the empty cyst's one";
  OFString label;
  segmentation->getSegment(2)->getSegmentLabel(label);
  EXPECT_EQ(label, "tumour-1");
  OFVector<size_t> frames;
  segmentation->getFramesForSegment(1, frames);
  ASSERT_EQ(frames.size(), 6U);
  for (int k = 0; k < 6; ++k) {
    const DcmIODTypes::Frame* packed = segmentation->getFrame(frames[static_cast<std::size_t>(k)]);
    const std::unique_ptr<DcmIODTypes::Frame> frame(DcmSegUtils::unpackBinaryFrame(packed, rows, columns));
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) ASSERT_EQ(frame->pixData[j * columns + i], written[0].mask.at(i, j, k));
    }
  }
}

TEST(DicomSeg, TakesItsSourceFromTheSlices) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const fs::path folder = test::shared_data() / "dcmqi_liver_seg_ct3" / "ct-3slice";
  const auto source = segmentation_source({folder / "01.dcm", folder / "02.dcm", folder / "03.dcm"});
  ASSERT_TRUE(source) << source.error().message();
  EXPECT_EQ(source->series_uid, "1.2.392.200103.20080913.113635.1.2009.6.22.21.43.10.23430.1");
  EXPECT_EQ(source->frame_of_reference_uid, "1.2.392.200103.20080913.113635.3.2009.6.22.21.44.34.23882.1");
  EXPECT_EQ(source->instances.size(), 3U);
}

TEST(DicomSeg, RefusesWhatItCannotTrust) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const fs::path folder = test::shared_data() / "dcmqi_liver_seg_ct3";
  EXPECT_EQ(read_dicom_seg(folder / "ct-3slice" / "01.dcm").error().code, "dicom-seg-not-a-segmentation");
  EXPECT_FALSE(read_dicom_seg(folder / "liver_seg.nrrd"));

  const TemporaryFolder temporary;
  const std::string whole = *read_text_file(folder / "liver.dcm");
  for (const std::size_t kept : {whole.size() - 20, whole.size() / 2, std::size_t{3000}, std::size_t{140}}) {
    const fs::path cut = temporary.path() / "cut.dcm";
    ASSERT_TRUE(write_text_file(cut, whole.substr(0, kept)));
    EXPECT_FALSE(read_dicom_seg(cut)) << kept << " bytes";
  }
  // A declared number of frames that the file does not have.
  std::string many = whole;
  const auto at = many.find("IS", many.find(std::string("\x28\x00\x08\x00", 4)));
  many.replace(at + 4, 2, "99");
  ASSERT_TRUE(write_text_file(temporary.path() / "many.dcm", many));
  EXPECT_EQ(read_dicom_seg(temporary.path() / "many.dcm").error().code, "dicom-seg-bad-geometry");
}

TEST(Cielab, GoesToSrgbAndBack) {
  for (const std::array<double, 3>& color :
       {std::array{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {0.5, 0.25, 0.75}, {1.0, 0.0, 0.0}}) {
    const auto back = srgb_from_cielab(cielab_from_srgb(color));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], color[c], 1e-3);
  }
  // White is L* = 100, a* = b* = 0 (up to the rounding of the published matrix).
  const auto white = cielab_from_srgb({1, 1, 1});
  EXPECT_NEAR(white[0], 65535, 2);
  EXPECT_NEAR(white[1], 128.0 / 255 * 65535, 30);
}

}  // namespace
}  // namespace glisson::imaging
