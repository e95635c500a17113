// What reading gives back: the values that were written, whichever way they were coded, in the right places.

#include "imaging/read_series.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <numbers>

#include "base/files.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;
using test::SliceSpec;
using testing::HasSubstr;

class ReadSeries : public testing::Test {
 protected:
  Series only_series() const {
    const Result<Study> study = scan(folder_.path());
    EXPECT_TRUE(study.has_value());
    if (!study || study->series.size() != 1) {
      ADD_FAILURE() << "not one series";
      return {};
    }
    return study->series.front();
  }
  Volume read() const {
    const Series series = only_series();
    if (series.layout == nullptr) return {};
    Result<Volume> volume = read_series(series);
    EXPECT_TRUE(volume.has_value()) << (volume ? "" : volume.error().message());
    return volume ? *volume : Volume{};
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

// A ramp that no two neighbours share, so that a swap of rows, columns or bytes shows.
int ramp(int i, int j) { return 37 * i + 501 * j; }

void expect_ramp(const Volume& volume, int k = 0, double slope = 1, double intercept = 0) {
  ASSERT_FALSE(volume.values.empty());
  for (int j = 0; j < volume.grid.size[1]; ++j) {
    for (int i = 0; i < volume.grid.size[0]; ++i) {
      ASSERT_FLOAT_EQ(volume.at(i, j, k), static_cast<float>(slope * ramp(i, j) + intercept)) << i << " " << j;
    }
  }
}

struct NamedSyntax {
  const char* name;
  E_TransferSyntax syntax;
};

class EveryCoding : public ReadSeries, public testing::WithParamInterface<NamedSyntax> {};

TEST_P(EveryCoding, GivesBackSixteenBits) {
  SliceSpec spec;
  spec.columns = 33;
  spec.rows = 21;
  spec.value = ramp;
  test::save_slice(spec, path("a.dcm"), GetParam().syntax);
  expect_ramp(read());
}

TEST_P(EveryCoding, GivesBackEightBits) {
  SliceSpec spec;
  spec.bits_allocated = spec.bits_stored = 8;
  spec.columns = 16;
  spec.rows = 7;
  spec.value = [](int i, int j) { return 16 * j + i; };
  test::save_slice(spec, path("a.dcm"), GetParam().syntax);
  const Volume volume = read();
  ASSERT_EQ(volume.values.size(), 112U);
  for (std::size_t n = 0; n < 112; ++n) ASSERT_FLOAT_EQ(volume.values[n], static_cast<float>(n));
}

INSTANTIATE_TEST_SUITE_P(ReadSeries, EveryCoding,
                         testing::Values(NamedSyntax{"ImplicitLittle", EXS_LittleEndianImplicit},
                                         NamedSyntax{"ExplicitLittle", EXS_LittleEndianExplicit},
                                         NamedSyntax{"ExplicitBig", EXS_BigEndianExplicit},
                                         NamedSyntax{"RunLength", EXS_RLELossless},
                                         NamedSyntax{"JpegLossless", EXS_JPEGProcess14SV1},
                                         NamedSyntax{"JpegLs", EXS_JPEGLSLossless}),
                         [](const auto& name) { return name.param.name; });

TEST_F(ReadSeries, ComesNearInJpegBaseline) {
  SliceSpec spec;
  spec.bits_allocated = spec.bits_stored = 8;
  spec.columns = spec.rows = 32;
  spec.value = [](int i, int j) { return 3 * i + 4 * j; };
  test::save_slice(spec, path("a.dcm"), EXS_JPEGProcess1);
  const Volume volume = read();
  ASSERT_EQ(volume.values.size(), 1024U);
  // Quality 100 rounds each coefficient to whole numbers; 2 of 255 is what that leaves on a ramp.
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) EXPECT_NEAR(volume.at(i, j, 0), 3 * i + 4 * j, 2);
  }
}

TEST_F(ReadSeries, ExtendsTheSignAndDropsTheBitsAboveIt) {
  SliceSpec spec;
  spec.bits_stored = 12;
  spec.is_signed = true;
  // -5 in twelve bits, under an overlay plane in bit 14.
  spec.value = [](int, int) { return 0x4FFB; };
  test::save_slice(spec, path("a.dcm"));
  EXPECT_FLOAT_EQ(read().at(1, 1, 0), -5);
}

TEST_F(ReadSeries, AppliesTheRescaleOfEachSliceByItself) {
  for (int k = 0; k < 3; ++k) {
    SliceSpec spec;
    spec.position_mm[2] = 2.0 * k;
    spec.instance_number = k;
    spec.value = ramp;
    const auto file = test::dicom_slice(spec);
    file->getDataset()->putAndInsertString(DCM_RescaleSlope, fmt::format("{}", 0.25 * (k + 1)).c_str());
    file->getDataset()->putAndInsertString(DCM_RescaleIntercept, fmt::format("{}", -100 * k).c_str());
    test::save(*file, path(fmt::format("{}.dcm", k)));
  }
  const Volume volume = read();
  for (int k = 0; k < 3; ++k) expect_ramp(volume, k, 0.25 * (k + 1), -100 * k);
}

TEST_F(ReadSeries, PrefersARealWorldValueMappingWithAUnit) {
  SliceSpec spec;
  spec.description = "Elastogram";
  spec.value = ramp;
  const auto file = test::dicom_slice(spec);
  DcmDataset& data_set = *file->getDataset();
  data_set.putAndInsertString(DCM_RescaleSlope, "7");
  data_set.putAndInsertString(DCM_RescaleIntercept, "3");
  DcmItem* mapping = nullptr;
  DcmItem* unit = nullptr;
  data_set.findOrCreateSequenceItem(DCM_RealWorldValueMappingSequence, mapping, 0);
  mapping->putAndInsertFloat64(DCM_RealWorldValueSlope, 0.001);
  mapping->putAndInsertFloat64(DCM_RealWorldValueIntercept, 0.5);
  mapping->findOrCreateSequenceItem(DCM_MeasurementUnitsCodeSequence, unit, 0);
  unit->putAndInsertString(DCM_CodeValue, "kPa");
  test::save(*file, path("a.dcm"));
  const Series series = only_series();
  EXPECT_EQ(series.unit, "kPa");
  EXPECT_THAT(series.unit_evidence, HasSubstr("real-world-value"));
  EXPECT_EQ(series.role, Role::mre_stiffness);
  expect_ramp(read(), 0, 0.001, 0.5);
}

TEST_F(ReadSeries, PutsTheFramesOfAnEnhancedImageInOrderOfPosition) {
  SliceSpec spec;
  std::vector<Eigen::Vector3d> positions;
  for (const int k : {3, 0, 2, 1, 4}) positions.emplace_back(0, 0, 2.5 * k);
  const auto file = test::enhanced_image(spec, positions, [&](int n, int i, int j) {
    return static_cast<int>(positions[std::size_t(n)][2] * 10) + i + 8 * j;
  });
  for (const E_TransferSyntax syntax : {EXS_LittleEndianExplicit, EXS_RLELossless, EXS_JPEGLSLossless}) {
    test::save(*file, path("enhanced.dcm"), syntax);
    const Volume volume = read();
    ASSERT_EQ(volume.grid.size, (std::array{8, 6, 5}));
    EXPECT_NEAR(volume.grid.spacing_mm[2], 2.5, 1e-9);
    for (int k = 0; k < 5; ++k) EXPECT_FLOAT_EQ(volume.at(2, 3, k), static_cast<float>(25 * k + 26));
  }
}

TEST_F(ReadSeries, TakesFloatPixelsAsTheyAre) {
  SliceSpec spec;
  spec.bits_allocated = spec.bits_stored = 32;
  const auto file = test::dicom_slice(spec);
  DcmDataset& data_set = *file->getDataset();
  data_set.findAndDeleteElement(DCM_PixelData);
  std::vector<Float32> values;
  for (int n = 0; n < 48; ++n) values.push_back(0.125F * static_cast<Float32>(n));
  values[7] = std::numeric_limits<Float32>::quiet_NaN();
  data_set.putAndInsertFloat32Array(DCM_FloatPixelData, values.data(), values.size());
  ASSERT_TRUE(file->saveFile(path("float.dcm").c_str(), EXS_LittleEndianExplicit).good());
  const Volume volume = read();
  ASSERT_EQ(volume.values.size(), 48U);
  EXPECT_FLOAT_EQ(volume.values[9], 1.125F);
  EXPECT_FLOAT_EQ(volume.values[7], 0);
}

// PS3.3 leaves mosaics to Siemens: the position in the header is that of a slice as large as the whole mosaic about
// the same centre.
TEST_F(ReadSeries, UnpacksAMosaicWithItsTilesInPlace) {
  SliceSpec spec;
  spec.columns = 12;  // 3 x 3 tiles of 4 x 5, seven of them used
  spec.rows = 15;
  spec.image_type = "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC";
  spec.value = [](int i, int j) { return 100 * (i / 4 + 3 * (j / 5)) + i % 4 + 4 * (j % 5); };
  const auto file = test::dicom_slice(spec);
  DcmDataset& data_set = *file->getDataset();
  data_set.putAndInsertString(DCM_SpacingBetweenSlices, "2.5");
  data_set.putAndInsertString(DcmTag(0x0019, 0x0010, EVR_LO), "SIEMENS MR HEADER");
  data_set.putAndInsertUint16(DcmTag(0x0019, 0x100a, EVR_US), 7);
  test::save(*file, path("mosaic.dcm"));
  const Volume volume = read();
  ASSERT_EQ(volume.grid.size, (std::array{4, 5, 7}));
  // Half the difference of the sizes: (12 - 4) / 2 columns of 1.5 mm and (15 - 5) / 2 rows of 2 mm.
  EXPECT_LT((volume.grid.origin_mm - Eigen::Vector3d(-10 + 6, -20 + 10, 30)).norm(), 1e-9);
  EXPECT_NEAR(volume.grid.spacing_mm[2], 2.5, 1e-9);
  for (int k = 0; k < 7; ++k) EXPECT_FLOAT_EQ(volume.at(3, 2, k), static_cast<float>(100 * k + 3 + 8));
}

TEST_F(ReadSeries, ScalesSiemensPhaseToRadians) {
  SliceSpec spec;
  spec.image_type = "ORIGINAL\\PRIMARY\\P\\ND";
  spec.description = "mre";
  spec.value = [](int i, int) { return i == 0 ? 0 : 3072; };
  const auto file = test::dicom_slice(spec);
  file->getDataset()->putAndInsertString(DCM_Manufacturer, "SIEMENS");
  file->getDataset()->putAndInsertString(DCM_RescaleSlope, "2");
  file->getDataset()->putAndInsertString(DCM_RescaleIntercept, "-4096");
  test::save(*file, path("a.dcm"));
  const Volume volume = read();
  EXPECT_EQ(volume.unit, "rad");
  EXPECT_NEAR(volume.at(0, 0, 0), -std::numbers::pi, 1e-6);
  EXPECT_NEAR(volume.at(1, 0, 0), std::numbers::pi / 2, 1e-6);
}

#if !defined(__SANITIZE_ADDRESS__)
// A program of its own under CTest, so that its largest extent in memory is that of this test.
TEST_F(ReadSeries, HoldsNoSecondCopyOfTheVolume) {
  SliceSpec spec;
  spec.columns = spec.rows = 512;
  test::save_stack(folder_.path(), 64, spec);
  const Series series = only_series();
  const auto largest_extent_bytes = [] {
    ::rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024;
  };
  const double before = largest_extent_bytes();
  const Result<Volume> volume = read_series(series);
  ASSERT_TRUE(volume.has_value());
  const double volume_bytes = 4.0 * 512 * 512 * 64;
  // Beside the volume's 64 MiB: two threads with a slice of half a MiB each, and their stacks.
  EXPECT_LT(largest_extent_bytes() - before, 1.15 * volume_bytes);
}
#endif

TEST_F(ReadSeries, NamesTheFileThatHasGoneOrChanged) {
  test::save_stack(folder_.path(), 6);
  const Series series = only_series();
  fs::rename(path("IM_0003.dcm"), path("elsewhere"));
  const Result<Volume> gone = read_series(series);
  ASSERT_FALSE(gone.has_value());
  EXPECT_EQ(gone.error().code, "file-not-readable");
  EXPECT_THAT(gone.error().message(), HasSubstr("IM_0003.dcm"));
  test::write_bytes(path("IM_0003.dcm"), test::bytes_of(path("elsewhere")).substr(0, 400));
  EXPECT_EQ(read_series(series).error().code, "dicom-changed");
}

TEST_F(ReadSeries, StopsWhenCancelled) {
  test::save_stack(folder_.path(), 6);
  std::stop_source stop;
  stop.request_stop();
  const Result<Volume> stopped = read_series(only_series(), 0, Progress({}, stop.get_token()));
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, "cancelled");
}

}  // namespace
}  // namespace glisson::imaging
