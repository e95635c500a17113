// Real series, judged by ITK's own series reader and GDCM's own mosaic filter.

#include <gdcmImageReader.h>
#include <gdcmSplitMosaicFilter.h>
#include <gdcmTrace.h>
#include <gmock/gmock.h>
#include <itkGDCMImageIO.h>
#include <itkImageSeriesReader.h>
#include <algorithm>
#include <numbers>

#include "imaging/read_series.h"
#include "imaging/stiffness_map.h"
#include "support/data.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

using ItkVolume = itk::Image<float, 3>;

ItkVolume::Pointer read_by_itk(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.string());
  gdcm::Trace::WarningOff();
  const auto reader = itk::ImageSeriesReader<ItkVolume>::New();
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->SetFileNames(names);
  reader->Update();
  return reader->GetOutput();
}

// Every voxel the same, and standing within a hundredth of a millimetre of where ITK has it.
void expect_as_itk_reads_it(const Series& series) {
  const Result<Volume> volume = read_series(series);
  ASSERT_TRUE(volume.has_value()) << volume.error().message();
  const ItkVolume::Pointer judge = read_by_itk(series.files);
  const auto size = judge->GetLargestPossibleRegion().GetSize();
  for (unsigned axis = 0; axis < 3; ++axis) ASSERT_EQ(static_cast<int>(size[axis]), volume->grid.size[axis]);
  EXPECT_TRUE(std::equal(volume->values.begin(), volume->values.end(), judge->GetBufferPointer()));
  for (const int k : {0, volume->grid.size[2] - 1}) {
    ItkVolume::PointType point;
    judge->TransformIndexToPhysicalPoint({{5, 7, k}}, point);
    EXPECT_LT((Eigen::Vector3d(point[0], point[1], point[2]) - volume->grid.position_mm(5, 7, k)).norm(), 0.01);
  }
}

Series find(const fs::path& folder, const std::string& description) {
  const Result<Study> study = scan(folder);
  if (!study) return {};
  for (const Series& series : study->series) {
    if (series.description == description && !series.modality.empty()) return series;
  }
  ADD_FAILURE() << "no series " << description << " in " << folder;
  return {};
}

TEST(RealData, MouseAbdomenIsReadAsItkReadsIt) {
  GLISSON_NEEDS_DATA("mouse_abdomen_mr_dicom");
  const Series series = find(test::shared_data() / "mouse_abdomen_mr_dicom", "TSE45 split");
  EXPECT_EQ(series.role, Role::anatomy);
  EXPECT_EQ(series.grid.size, (std::array{320, 960, 36}));
  EXPECT_NEAR(series.grid.spacing_mm[2], 0.5, 1e-6);
  EXPECT_THAT(series.problems, IsEmpty());
  expect_as_itk_reads_it(series);
}

TEST(RealData, Jpeg2000CtIsReadAsItkReadsIt) {
  GLISSON_NEEDS_DATA("totalseg_abdomen_mr_ct");
  const Series series = find(test::shared_data() / "totalseg_abdomen_mr_ct" / "example_ct_dicom", "CT Body 3.0");
  EXPECT_EQ(series.role, Role::anatomy);
  EXPECT_EQ(series.unit, "HU");
  // De-identification took the identifiers of this series; the folder stands for them.
  ASSERT_EQ(series.problems.size(), 1U);
  EXPECT_THAT(series.problems.front(), HasSubstr("No SeriesInstanceUID"));
  EXPECT_NEAR(series.grid.spacing_mm[2], 2, 1e-6);  // while SliceThickness is 3
  expect_as_itk_reads_it(series);
}

TEST(RealData, ImplicitCtIsReadAsItkReadsItBesideItsSegmentation) {
  GLISSON_NEEDS_DATA("dcmqi_liver_seg_ct3");
  const Result<Study> study = scan(test::shared_data() / "dcmqi_liver_seg_ct3");
  ASSERT_TRUE(study.has_value());
  ASSERT_EQ(study->series.size(), 3U);
  const auto with_role = [&](Role role, const std::string& modality) {
    return std::find_if(study->series.begin(), study->series.end(),
                        [&](const Series& series) { return series.role == role && series.modality == modality; });
  };
  const auto ct = with_role(Role::anatomy, "CT");
  const auto segmentation = with_role(Role::segmentation, "SEG");
  ASSERT_NE(ct, study->series.end());
  ASSERT_NE(segmentation, study->series.end());
  EXPECT_TRUE(same_grid(ct->grid, segmentation->grid, 0.01));
  EXPECT_EQ(read_series(*segmentation).error().code, "dicom-segmentation");
  expect_as_itk_reads_it(*ct);
}

TEST(RealData, SiemensMosaicsAreTakenApartAsGdcmDoes) {
  GLISSON_NEEDS_DATA("mre_brain_ir_charite");
  const fs::path folder = test::shared_data() / "mre_brain_ir_charite" / "volunteer_A";
  const Result<Study> study = scan(folder);
  ASSERT_TRUE(study.has_value());
  ASSERT_EQ(study->series.size(), 4U);
  for (const Series& series : study->series) {
    EXPECT_EQ(series.volumes, 24) << series.description;
    EXPECT_EQ(series.grid.size, (std::array{110, 108, 5}));
    EXPECT_NEAR(series.grid.spacing_mm[2], 4, 1e-5);
    EXPECT_THAT(series.problems, IsEmpty());
    EXPECT_EQ(series.role, series.number % 2 == 0 ? Role::mre_phase : Role::mre_magnitude);
  }
  const Series& magnitude = study->series[2];
  const Result<Volume> volume = read_series(magnitude, 6);
  ASSERT_TRUE(volume.has_value());

  gdcm::ImageReader reader;
  reader.SetFileName((folder / "series_047_mre_Inv2900_mag" / "0007.dcm").c_str());
  ASSERT_TRUE(reader.Read());
  gdcm::SplitMosaicFilter split;
  split.SetImage(reader.GetImage());
  split.SetFile(reader.GetFile());
  ASSERT_TRUE(split.Split());
  const gdcm::Image& judge = split.GetImage();
  std::vector<char> buffer(judge.GetBufferLength());
  ASSERT_TRUE(judge.GetBuffer(buffer.data()));
  ASSERT_EQ(buffer.size(), volume->values.size() * 2);
  for (std::size_t n = 0; n < volume->values.size(); ++n) {
    std::uint16_t stored = 0;
    std::memcpy(&stored, buffer.data() + 2 * n, 2);
    ASSERT_FLOAT_EQ(volume->values[n], stored);
  }
  // Where the first tile stands GDCM leaves open (it gives the mosaic's own position). But SliceLocation, 18.436 mm, is
  // the distance of the first slice from the isocentre, and the head was scanned about the isocentre: the middle of the
  // field of view is within 2 cm of it, where without the correction it would be 30 cm off.
  const Grid& grid = volume->grid;
  EXPECT_NEAR(grid.direction.col(2).dot(grid.origin_mm), 18.436, 1e-3);
  EXPECT_LT(grid.position_mm(Eigen::Vector3d(54.5, 53.5, 0)).head<2>().norm(), 20);
  double normal[3];
  bool inverted = false;
  ASSERT_TRUE(split.ComputeMOSAICSliceNormal(normal, inverted));
  EXPECT_GT(grid.direction.col(2).dot(Eigen::Vector3d(normal[0], normal[1], normal[2])), 0.999999);
}

// Three directions by eight instants, and which is which only ImageComments say. The directions that they name are the
// axes of the images to within the rounding of the angles to whole degrees.
TEST(RealData, AnElastographySeriesSaysWhichMotionEachVolumeWasEncodedFor) {
  GLISSON_NEEDS_DATA("mre_brain_ir_charite");
  const Result<Study> study = scan(test::shared_data() / "mre_brain_ir_charite" / "volunteer_A");
  ASSERT_TRUE(study.has_value() && study->series.size() == 4);
  const Series& phase = study->series[1];
  ASSERT_EQ(phase.motion.size(), 24U);
  const Eigen::Matrix3d& axes = phase.grid.direction;
  const std::array<Eigen::Vector3d, 3> directions{-axes.col(2), -axes.col(1), axes.col(0)};
  for (std::size_t v = 0; v < 24; ++v) {
    const MotionEncoding& motion = phase.motion[v];
    EXPECT_EQ(motion.frequency_Hz, 20.0);
    EXPECT_EQ(motion.direction, static_cast<int>(v / 8));
    EXPECT_EQ(motion.offset, static_cast<int>(v % 8));
    ASSERT_TRUE(motion.along.has_value());
    EXPECT_GT(motion.along->dot(directions[v / 8]), std::cos(std::numbers::pi / 180));
    ASSERT_EQ(motion.slice_times_s.size(), 5U);
    EXPECT_NEAR(motion.slice_times_s[1], 11.94, 1e-6);  // the slices are interleaved
    EXPECT_NEAR(motion.slice_times_s[2], 3.98, 1e-6);
  }
}

TEST(RealData, MeasuredPhaseFillsTheWholeCircle) {
  GLISSON_NEEDS_DATA("mre_brain_ir_charite");
  const Result<Study> study = scan(test::shared_data() / "mre_brain_ir_charite" / "volunteer_A");
  ASSERT_TRUE(study.has_value() && study->series.size() == 4);
  const Result<Volume> phase = read_series(study->series[3]);
  ASSERT_TRUE(phase.has_value());
  EXPECT_EQ(phase->unit, "rad");
  const auto [minimum, maximum] = std::minmax_element(phase->values.begin(), phase->values.end());
  EXPECT_NEAR(*minimum, -3.1416, 0.002);  // one step of the twelve bits is 0.0015 rad
  EXPECT_NEAR(*maximum, 3.1416, 0.002);
}

TEST(RealData, PublishedBrainStiffnessInPascalIsRecognisedByItsSize) {
  GLISSON_NEEDS_DATA("mre134_brain_maps");
  const Result<Study> study = scan(test::shared_data() / "mre134_brain_maps" / "individual");
  ASSERT_TRUE(study.has_value());
  int maps = 0;
  for (const Series& series : study->series) {
    if (series.role != Role::mre_stiffness) continue;
    ++maps;
    Result<Volume> stored = read_series(series);
    ASSERT_TRUE(stored.has_value());
    const Result<StiffnessMap> map = stiffness_in_kPa(std::move(*stored), series.unit_evidence);
    ASSERT_TRUE(map.has_value()) << map.error().message();
    EXPECT_THAT(map->evidence, HasSubstr("only in Pa"));
    // The published mean of the cohort's brains is 2.6 to 2.9 kPa (Hiscox et al. 2020).
    double sum = 0;
    int count = 0;
    for (const float value : map->shear_kPa.values) {
      if (value > 0) sum += value, ++count;
    }
    EXPECT_GT(sum / count, 2);
    EXPECT_LT(sum / count, 4);
  }
  EXPECT_GT(maps, 0);
}

}  // namespace
}  // namespace glisson::imaging
